// SPDX-License-Identifier: MIT
// Sets of texts and the paths between them.
// A folder as a set of texts: what it gives, lists and refuses.
// Diagnostics as people and as programs see them.
#include <crevice/diagnostic.h>
#include <crevice/document.h>
#include <crevice/source.h>

#include "core/base/text.h"

#include "tests/support/need.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>

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

TEST_CASE("a relative path is seen from the folder of the file that writes it")
{
    CHECK(resolvePath("configs/a.json", "./b.frag") == "configs/b.frag");
    CHECK(resolvePath("configs/a.json", "../ssao/b.frag") == "ssao/b.frag");
    CHECK(resolvePath("a.json", "./b.frag") == "b.frag");
    CHECK(resolvePath("x/y/a.json", "../../b/./../c.frag") == "c.frag");
    CHECK(resolvePath("/home/me/a.json", "../b.json") == "/home/b.json");
    CHECK(resolvePath("./a.json", "./b.json") == "./b.json");
}

TEST_CASE("a catalog path does not climb above its root, a path on disk may")
{
    CHECK(resolvePath("configs/a.json", "../../b.frag").empty());
    CHECK(resolvePath("a.json", "../b.frag").empty());
    CHECK(resolvePath("./a.json", "../b.frag") == "../b.frag");
    CHECK(resolvePath("../a.json", "../b.frag") == "../../b.frag");
    CHECK(std::filesystem::path(resolvePath("/a.json", "../b.frag")).lexically_normal() ==
          "/b.frag");
}

TEST_CASE("text for a terminal has no control characters and turns no direction")
{
    CHECK(printable("a\x1B]0;b\x07 \x7F\r") == "a\\u001b]0;b\\u0007 \\u007f\\u000d");
    CHECK(printable("\xC2\x80\xC2\x9B\xC2\x9F") == "\\u0080\\u009b\\u009f");
    CHECK(printable("\xE2\x80\xAA\xE2\x80\xAE\xE2\x81\xA6\xE2\x81\xA9") ==
          "\\u202a\\u202e\\u2066\\u2069");
    CHECK(printable("\xE2\x80\x8E\xE2\x80\x8F\xD8\x9C") == "\\u200e\\u200f\\u061c");
    CHECK(printable("\xE2\x80\xA8\xE2\x80\xA9") == "\\u2028\\u2029");
    CHECK(printable("\x9B\xC3") == "\xEF\xBF\xBD\xEF\xBF\xBD");
    const std::string shown = "a\tb\n\xC2\xA0\xC3\xA4 \xD8\xA7\xD7\x90\xE2\x80\x90\xF0\x9F\x99\x82";
    CHECK(printable(shown) == shown);
    CHECK(printable(printable("\x1B")) == "\\u001b");
    CHECK(printableLine("a\nb\t") == "a\\u000ab\\u0009");
    CHECK(jsonString("\x7F\xC2\x9B\xE2\x80\xAE") == R"("\u007f\u009b\u202e")");
}

namespace fs = std::filesystem;

TEST_CASE("a folder lists its texts below it and nothing else")
{
    const TemporaryFolder folder("source_list");
    for (const char* name : {"b/x.frag", "a.json", "b/y.glsl", "c/d/z.vert", "k.comp"})
        folder.write(name, "");
    for (const char* name : {"notes.txt", "a.json~", "b/picture.png", "json"})
        folder.write(name, "");
    fs::create_directories(folder.path / "folder.json");
    const DirectorySources sources(folder.path.string());
    CHECK(sources.list() ==
          std::vector<std::string>{"a.json", "b/x.frag", "b/y.glsl", "c/d/z.vert", "k.comp"});
    CHECK(DirectorySources((folder.path / "none").string()).list().empty());
}

TEST_CASE("a folder does not give what lies outside of it")
{
    const TemporaryFolder folder("source_climb");
    folder.write("secret.json", "secret");
    folder.write("root/a.json", "a");
    const DirectorySources sources((folder.path / "root").string());
    CHECK(sources.find("a.json"));
    for (const std::string path :
         {"../secret.json", "x/../../secret.json", "./a.json", "", "..", "a.json/", "//a.json"})
        CHECK_FALSE(sources.find(path));
    CHECK_FALSE(sources.find((folder.path / "secret.json").string()));
}

TEST_CASE("a folder of modules gives no link out of it, but for its roots")
{
    const TemporaryFolder folder("source_links");
    folder.write("secret.env", "secret");
    const std::string mine = (folder.path / "mine").string();
    fs::create_directories(mine);
    fs::create_symlink("../secret.env", mine + "/a.glsl");
    CHECK_FALSE(DirectorySources(mine).find("a.glsl"));
    CHECK(DirectorySources(mine, {folder.path.string()}).find("a.glsl"));
}

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
    const Node read = need(parseDocument(textOf(json)));
    const Node* list = read.find("list");
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
