// SPDX-License-Identifier: MIT
// Documents: values with their places, and every way in which a text is none.
#include <crevice/document.h>

#include "core/base/text.h"

#include "tests/support/need.h"

#include <ctime>

using namespace crevice;

namespace {

SourceRef textOf(const std::string& text)
{
    return std::make_shared<SourceText>(SourceText{"my.json", text});
}

Node documentOf(const std::string& text) { return need(parseDocument(textOf(text))); }

// "line:column+length".
std::string spanOf(const Place& place)
{
    return std::to_string(place.line) + ":" + std::to_string(place.column) + "+" +
           std::to_string(place.length);
}

// Where the one error of a text is, which has that code.
std::string failureOf(const std::string& text, Code code = Code::syntax)
{
    const Diagnostic error = onlyError(parseDocument(textOf(text)), code);
    CHECK(error.place.source);
    CHECK(error.message.back() != '.');
    return spanOf(error.place);
}

std::string nested(int levels)
{
    std::string text = "{\"a\":";
    for (int i = 1; i < levels; ++i) text += '[';
    if (levels == 1) text += '1';
    for (int i = 1; i < levels; ++i) text += ']';
    return text + "}";
}

}  // namespace

TEST_CASE("every kind of value is read")
{
    const Node node = documentOf(R"({"n": null, "t": true, "f": false, "i": 3, "s": "x\n\u00e4",
                                     "a": [1, [2]], "o": {"k": -0.5e1}})");
    CHECK(node.find("n")->kind == Node::Kind::null);
    CHECK(node.find("t")->boolean);
    CHECK_FALSE(node.find("f")->boolean);
    CHECK(node.find("i")->number == 3);
    CHECK(node.find("s")->text == "x\n\xC3\xA4");
    CHECK(node.find("a")->items.at(1).items.at(0).number == 2);
    CHECK(node.find("o")->find("k")->number == -5);
    CHECK(node.find("none") == nullptr);
    CHECK(node.find("i")->find("x") == nullptr);
    CHECK(node.members.size() == 7);
    CHECK(node.members[3].key == "i");
}

TEST_CASE("keys and values know where they stand")
{
    const Node node = documentOf(
        "{\n  \"radius\" :\t{ \"min\": -12.5e3,\r\n"
        "\"x\\\"y\": [ true , \"\xC3\xA4,:\" ] }\n}");
    const Member& radius = node.members.at(0);
    CHECK(spanOf(node.place) == "1:1+1");
    CHECK(spanOf(radius.key_place) == "2:3+8");
    CHECK(spanOf(radius.value.place) == "2:14+1");
    CHECK(spanOf(radius.value.members.at(0).key_place) == "2:16+5");
    CHECK(spanOf(radius.value.members.at(0).value.place) == "2:23+7");
    CHECK(radius.value.members.at(0).value.text == "-12.5e3");
    CHECK(spanOf(radius.value.members.at(1).key_place) == "3:1+6");
    const Node& list = radius.value.members.at(1).value;
    CHECK(spanOf(list.place) == "3:9+1");
    CHECK(spanOf(list.items.at(0).place) == "3:11+4");
    CHECK(spanOf(list.items.at(1).place) == "3:18+6");
    CHECK(list.place.source->name == "my.json");
}

TEST_CASE("the text at a value's place is that value")
{
    const std::string text = R"({"\u00e4\\" :[ 0,-1.5E+3 ,"\"]","" ,[],{} ,true, false,null],)"
                             "\n\t"
                             R"("b":"€\ud83d\ude42"})";
    const Node node = documentOf(text);
    std::vector<const Node*> values = {node.find("b")};
    for (const Node& item : node.members.at(0).value.items) values.push_back(&item);
    for (const Node* value : values) {
        const std::size_t line = value->place.line == 1 ? 0 : text.find('\n') + 1;
        const bool nested_value = value->kind >= Node::Kind::array;
        const std::string slice =
            text.substr(line + value->place.column - 1, nested_value ? 2 : value->place.length);
        const Node again = need(parseValue(textOf(slice)));
        CHECK(again.kind == value->kind);
        CHECK(brief(again) == brief(*value));
    }
}

TEST_CASE("a number is an integer only when it is written as one and a double holds it")
{
    const auto integer = [](const std::string& number) {
        const Node node = documentOf("{\"a\": " + number + "}");
        return node.find("a")->integer();
    };
    for (const char* yes : {"0", "-0", "12", "-7", "9007199254740992", "-9007199254740992"})
        CHECK(integer(yes));
    for (const char* no : {"1.0", "1e3", "1E3", "16.7", "9007199254740994", "18446744073709551616"})
        CHECK_FALSE(integer(no));
}

TEST_CASE("the size ends at one mebibyte")
{
    std::string text = "{\"a\": \"";
    text += std::string(kMaxDocumentBytes - text.size() - 2, 'x') + "\"}";
    CHECK(parseDocument(textOf(text)));
    failureOf(text + " ", Code::too_large);
}

TEST_CASE("a mebibyte of the smallest values does not cost its square")
{
    std::string text = "{\"a\":[0";
    while (text.size() < kMaxDocumentBytes - 4) text += ",0";
    const SourceRef source = textOf(text + "]}");
    const std::clock_t begin = std::clock();
    CHECK(parseDocument(source).ok());
    const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    CHECK(taken < 30);  // seconds of this process: under qemu 1.4, and what is quadratic minutes
}

TEST_CASE("the depth ends at 64 levels")
{
    CHECK(parseDocument(textOf(nested(kMaxDocumentDepth))));
    CHECK(failureOf(nested(kMaxDocumentDepth + 1), Code::too_deep) == "1:69+1");
    failureOf("{\"a\":" + std::string(500000, '['), Code::too_deep);
}

TEST_CASE("all duplicate keys are found, and a syntax error behind them too")
{
    const Result<Node> document =
        parseDocument(textOf("{\"b\": {\"x\": 1, \"x\": 2}, \"a\": 1, \"a\": 1, \"a\": 1 !}"));
    REQUIRE(document.diagnostics().size() == 4);
    CHECK(spanOf(document.diagnostics()[0].place) == "1:16+3");
    CHECK(spanOf(document.diagnostics()[1].place) == "1:33+3");
    CHECK(spanOf(document.diagnostics()[2].place) == "1:41+3");
    CHECK(document.diagnostics()[3].code == Code::syntax);
}

TEST_CASE("a zero byte does not end a document")
{
    CHECK(failureOf(std::string("{}\0{}", 5)) == "1:3+1");
    CHECK(failureOf(std::string("{\"a\": 1\0}", 9)) == "1:8+1");
    CHECK(failureOf(std::string("{\"a\": \"\0\"}", 10), Code::syntax) == "1:8+1");
    failureOf(std::string("\0", 1));
}

TEST_CASE("every truncation and every changed byte of a document gives a value or a placed error")
{
    const std::string good =
        "{\"a\": [1.5e1, -0, true, null, \"x\\u00e4\\n\"], \"b\": {\"c\": {}}}\n";
    documentOf(good);
    const auto check = [](const std::string& text) {
        const Result<Node> document = parseDocument(textOf(text));
        if (document) return true;
        const Diagnostics& errors = document.diagnostics();
        const int line = errors.front().place.line;
        return !toText(errors).empty() && (line > 0 || errors.front().code == Code::empty_text);
    };
    for (std::size_t at = 0; at < good.size(); ++at) {
        CHECK(check(good.substr(0, at)));
        for (int byte = 0; byte < 256; ++byte) {
            std::string changed = good;
            changed[at] = static_cast<char>(byte);
            if (!check(changed)) FAIL("byte " << byte << " at " << at);
        }
    }
}

TEST_CASE("a value is any JSON, and a word is a string")
{
    const auto valueOf = [](const char* text) { return need(parseValue(textOf(text))); };
    CHECK(valueOf(" 0.8 ").number == 0.8);
    CHECK(valueOf("true").boolean);
    CHECK(valueOf("null").kind == Node::Kind::null);
    CHECK(valueOf("[1, 2]").items.size() == 2);
    CHECK(valueOf("\"12\"").text == "12");
    CHECK(valueOf("smooth step").text == "smooth step");
    for (const char* text : {"50cm", "0,5", ".5", "-x"})  // whoever wants a number says more
        CHECK(valueOf(text).text == text);
    CHECK(valueOf(" ./a.frag ").text == "./a.frag");
    CHECK(spanOf(valueOf("  hard ").place) == "1:3+4");
}

TEST_CASE("a value that is meant as JSON and is none is an error, not a word")
{
    for (const char* text : {"[1, 2", "{\"a\": }", "\"x", "1.2.3", ""})
        CHECK_FALSE(parseValue(textOf(text)));
    CHECK(parseValue(textOf("1e999")).diagnostics().front().code == Code::number_range);
}

TEST_CASE("a value in a message is one line and short")
{
    const Node node = documentOf("{\"a\": [1.50, \"x\",\n null], \"b\": {\"c\": true}}");
    CHECK(brief(node) == "{\"a\": [1.50, \"x\", null], \"b\": {\"c\": true...");
    CHECK(brief(*node.find("a")) == "[1.50, \"x\", null]");
    const Node wide = documentOf("{\"a\": \"" + std::string(300, 'x') + "\"}");
    CHECK(brief(*wide.find("a")).size() == 43);
    CHECK(brief(*documentOf("{\"a\": \"x\\ny\"}").find("a")) == "\"x\\ny\"");
    for (const char* start : {"", "x", "xx"}) {  // cut between characters, never within one
        std::string text = start;
        while (text.size() < 60) text += "\xE2\x82\xAC";
        const std::string shown = brief(*parseValue(textOf(text)));
        CHECK(shown == printable(shown));
    }
}

TEST_CASE("comments are read wherever white space may be")
{
    for (const char* text : {"{\"a\": [1, 2]} // why", "// why\n{\"a\": [1, 2]}",
                             "/**/{/* k */\"a\"/* c */:/***/[1/* 1 */,// 2\n2]}",
                             "{\"a\": [1, 2] /* two\nlines * / // */}", "{\"a\": [1, //\r\n2]}//",
                             "{\"a\": [1, // why\r2]}", "{\"a\": [1, 2] /* // \"*/ }",
                             "{\"a\": [1, 2 // \xC3\xA4, ], }\n]}"})
        CHECK(toJson(documentOf(text)) == "{\"a\": [1, 2]}");
}

TEST_CASE("a text keeps what looks like a comment or a last comma")
{
    for (const char* text : {"x // y", "/* x */", "\\\" // x", "[1,]", "\\\\"}) {
        const std::string json = std::string("{\"a\": \"") + text + "\", \"/*,}\": 1}";
        CHECK(toJson(documentOf(json)) == json);
    }
}

TEST_CASE("places are right behind comments and last commas")
{
    const Node node =
        documentOf("/* one\n   two */ { // three\n  \"a\": [1,], /* \xC3\xA4\n*/ \"b\": 2 }");
    const auto at = [](const Place& place) {
        return std::to_string(place.line) + ":" + std::to_string(place.column);
    };
    CHECK(at(node.place) == "2:11");
    CHECK(at(node.members[0].key_place) == "3:3");
    CHECK(at(node.members[0].value.items[0].place) == "3:9");
    CHECK(at(node.members[1].key_place) == "4:4");
    CHECK(at(node.members[1].value.place) == "4:9");
}
