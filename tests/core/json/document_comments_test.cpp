// SPDX-License-Identifier: MIT
// Comments and commas behind the last entry, in all JSON that users write.
#include <crevice/document.h>

#include "tests/support/catch.h"

using namespace crevice;

namespace {

SourceRef textOf(const std::string& text)
{
    return std::make_shared<SourceText>(SourceText{"my.json", text});
}

Node documentOf(const std::string& text)
{
    Result<Node> document = parseDocument(textOf(text));
    INFO(text << "\n" << toText(document.diagnostics()));
    REQUIRE(document);
    return std::move(*document);
}

Diagnostic failureOf(const std::string& text)
{
    const Result<Node> document = parseDocument(textOf(text));
    INFO(text);
    REQUIRE_FALSE(document);
    REQUIRE(document.diagnostics().size() == 1);
    return document.diagnostics().front();
}

}  // namespace

TEST_CASE("comments are read wherever white space may be")
{
    for (const char* text : {"{\"a\": [1, 2]} // why", "// why\n{\"a\": [1, 2]}",
                             "/**/{/* k */\"a\"/* c */:/***/[1/* 1 */,// 2\n2]}",
                             "{\"a\": [1, 2] /* two\nlines * / // */}", "{\"a\": [1, //\r\n2]}//",
                             "{\"a\": [1, // why\r2]}", "{\"a\": [1, 2] /* // \"*/ }",
                             "{\"a\": [1, 2 // \xC3\xA4, ], }\n]}"})
        CHECK(toJson(documentOf(text)) == "{\"a\": [1, 2]}");
}

TEST_CASE("a comma may stand behind the last entry")
{
    CHECK(toJson(documentOf("{\"a\": [1, 2,],}")) == "{\"a\": [1, 2]}");
    CHECK(toJson(documentOf("{\"a\": [[],], \"b\": {\"c\": null, // why\n},\n}\n")) ==
          "{\"a\": [[]], \"b\": {\"c\": null}}");
    CHECK(toJson(documentOf("{\"a\": \"x\" , /* why */ }")) == "{\"a\": \"x\"}");
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

TEST_CASE("what is wrong beside comments and commas is reported with its place")
{
    struct Case {
        const char* text;
        const char* place;
        const char* part;
    };
    const Case kCases[] = {
        {"{\"a\": 1 /* why\n", "my.json:1:9", "close it with '*/'"},
        {"{\n  /*/ }", "my.json:2:3", "does not end"},
        {"/* why", "my.json:1:1", "close it with '*/'"},
        {"// why\n/**/", "my.json:1:1", "nothing but white space and comments"},
        {"{\"a\": 1 # why\n}", "my.json:1:9", "a comment begins with '//'"},
        {"# why\n{}", "my.json:1:1", "a comment begins with '//'"},
        {"{,}", "my.json:1:2", "take the comma away"},
        {"{\"a\": [ /* , */ , ]}", "my.json:1:17", "take the comma away"},
        {"{\"a\": 1,,}", "my.json:1:9", "take one of the two commas away"},
        {"{\"a\": , }", "my.json:1:7", "found ',' where a value was wanted"},
        {"{\"a\" , }", "my.json:1:8", "where ':' was wanted"},
        {"{}, // why", "my.json:1:3", "take the comma away"},
        {"{\"a\": [1, /* ] */ }", "my.json:1:19", "close the array with ']'"},
        {"{\"a\": 1, // }", "my.json:1:8", "close it with '}'"},
        {"{\"a\": // 1\n}", "my.json:2:1", "where a value was wanted"},
        {"{\"a\": \"x // y\n}", "my.json:1:7", "found a string that does not end"},
        {"{\"a\": 1 / 2}", "my.json:1:9", "write the result"},
    };
    for (const Case& one : kCases) {
        const Diagnostic error = failureOf(one.text);
        INFO(toText(error));
        CHECK(placeName(error.place) == one.place);
        CHECK_THAT(error.message + "; " + error.help, Catch::Contains(one.part));
    }
    CHECK(failureOf("{} // \xFF").code == Code::bad_utf8);
    CHECK(failureOf("{\"a\": 1, /* \"a\": 2 */ \"a\": 3,}").code == Code::duplicate_key);
    CHECK(failureOf(std::string("{} // \0\n{", 10)).code == Code::syntax);
}

TEST_CASE("a value of the command line keeps what looks like a comment in a word")
{
    for (const char* word : {"./a//b.frag", "//a", "a/*", "http://x/*y*/"})
        CHECK(parseValue(textOf(word))->text == word);
    CHECK(toJson(*parseValue(textOf("[1, /* two */ 2,]"))) == "[1, 2]");
}
