// SPDX-License-Identifier: MIT
// Diagnostics as people and as programs see them.
#include <crevice/diagnostic.h>
#include <crevice/document.h>

#include "core/base/text.h"

#include "tests/support/catch.h"

using namespace crevice;

namespace {

SourceRef textOf(const std::string& text)
{
    return std::make_shared<SourceText>(SourceText{"my.json", text});
}

std::string shownLine(const std::string& text, int line)
{
    std::size_t begin = 0;
    for (int at = 0; at < line; ++at) begin = text.find('\n', begin) + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("a diagnostic shows place, line, marks, pointer, notes and help")
{
    const SourceRef mine = textOf("{\n\n\"a\": \"ao_filterd\" }\n");
    const SourceRef base = std::make_shared<SourceText>(SourceText{"base.json", ""});
    Diagnostic diagnostic{
        Code::target_missing, "pass 'a' reads target 'ao_filterd'", {}, {mine, 3, 6, 12}};
    diagnostic.pointer = "/passes/a";
    diagnostic.notes.resize(2);
    diagnostic.notes[0].place = {base, 31, 21, 1};
    diagnostic.notes[0].text = "the base value was 'ao'";
    diagnostic.notes[1].text = "no place";
    diagnostic.help = "did you mean 'ao'?";
    CHECK(toText(diagnostic) ==
          "my.json:3:6: error CV2103: pass 'a' reads target 'ao_filterd'\n"
          "    3 | \"a\": \"ao_filterd\" }\n"
          "      |      ^~~~~~~~~~~~\n"
          "  at /passes/a\n"
          "  note: base.json:31:21: the base value was 'ao'\n"
          "  note: no place\n"
          "  help: did you mean 'ao'?\n");
}

TEST_CASE("the marks stay below the place after tabs and letters of several bytes")
{
    const std::string text =
        toText(Diagnostic{Code::usage, "m", {}, {textOf("\t\xC3\xA4 bad"), 1, 5, 3}});
    CHECK(shownLine(text, 1) == "    1 | \t\xC3\xA4 bad");
    CHECK(shownLine(text, 2) == "      | \t  ^~~");
}

TEST_CASE("places outside of the text do no harm")
{
    for (const int line : {1, 2, 3, 1000})
        for (const int column : {1, 2, 1000}) {
            const Place place{textOf("a\n"), line, column, -7};
            CHECK_THAT(toText(Diagnostic{Code::usage, "m", "", place}), Catch::Contains("^\n"));
        }
}

TEST_CASE("a long line is cut around the place")
{
    for (const int column : {1, 70, 200, 400, 1000}) {
        std::string line(1000, '.');
        line[column - 1] = 'X';
        const std::string text =
            toText(Diagnostic{Code::usage, "m", {}, {textOf(line), 1, column, 1}});
        const std::string shown = shownLine(text, 1), marks = shownLine(text, 2);
        CHECK(shown.size() < 180);
        CHECK(shown.find("...") != std::string::npos);
        CHECK(shown.find('X') == marks.find('^'));
    }
}

TEST_CASE("no part of a diagnostic controls the terminal or forges a line")
{
    const std::string bad = "\x1B]0;x\x07\xC2\x9B\xE2\x80\xAE\nerror CV0001: forged";
    Diagnostic diagnostic{
        Code::usage,
        bad,
        {},
        {std::make_shared<SourceText>(SourceText{bad, "\xE2\x80\xAE!\x7F"}), 1, 4, 1}};
    diagnostic.pointer = bad;
    diagnostic.notes = {{diagnostic.place, bad}};
    diagnostic.help = bad;
    const std::string text = toText(diagnostic);
    for (std::size_t i = 0; i < text.size(); ++i) CHECK((text[i] == '\n' || !isControl(text, i)));
    CHECK(std::count(text.begin(), text.end(), '\n') == 6);
    CHECK(shownLine(text, 1) == "    1 | ?!?");
    CHECK(shownLine(text, 2) == "      |  ^");
    const std::string json = toJson({diagnostic});
    CHECK(json.find('\x1B') == std::string::npos);
    CHECK(json.find("\xE2\x80\xAE") == std::string::npos);
}

TEST_CASE("diagnostics as JSON have every key and can be read back")
{
    Diagnostic diagnostic{Code::target_missing, "quote \" and \xFF", {}, {textOf("x"), 1, 2, 3}};
    diagnostic.pointer = "/a";
    diagnostic.notes = {{{}, "note"}};
    const std::string json = "{\"list\": " + toJson({diagnostic, diagnostic}) + "}";
    const Result<Node> read = parseDocument(textOf(json));
    REQUIRE(read);
    const Node* list = read->find("list");
    REQUIRE(list->items.size() == 2);
    const Node& first = list->items[0];
    CHECK(first.find("code")->text == "CV2103");
    CHECK(first.find("severity")->text == "error");
    CHECK(first.find("message")->text == "quote \" and \xEF\xBF\xBD");
    CHECK(first.find("file")->text == "my.json");
    CHECK(first.find("line")->number == 1);
    CHECK(first.find("column")->number == 2);
    CHECK(first.find("length")->number == 3);
    CHECK(first.find("pointer")->text == "/a");
    CHECK(first.find("notes")->items.at(0).find("text")->text == "note");
    CHECK(first.find("notes")->items.at(0).find("file")->kind == Node::Kind::null);
    CHECK(first.find("help")->text.empty());
    CHECK(toJson(Diagnostics{}) == "[]\n");
}

TEST_CASE("the name that was meant is found")
{
    const std::vector<std::string> names = {"ao",     "ao_filtered",     "color", "depth",
                                            "normal", "ssao/hemisphere", "radius"};
    const auto meant = [&](const char* written) {
        const std::string help = suggestName(written, names, "names");
        const std::string start = "did you mean '";
        if (help.compare(0, start.size(), start) != 0) return std::string();
        return help.substr(start.size(), help.find('\'', start.size()) - start.size());
    };
    CHECK(meant("ao_filterd") == "ao_filtered");
    CHECK(meant("dpeth") == "depth");
    CHECK(meant("colour") == "color");
    CHECK(meant("Normal") == "normal");
    CHECK(meant("AO_FILTERED") == "ao_filtered");
    CHECK(meant("rad") == "radius");
    CHECK(meant("hemisphere") == "ssao/hemisphere");
    CHECK(meant("velocity").empty());
    CHECK(meant("").empty());
    CHECK(meant(std::string(100000, 'a').c_str()).empty());
}
