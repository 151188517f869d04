// SPDX-License-Identifier: MIT
// Sets of texts and the paths between them.
#include <crevice/source.h>

#include "core/base/text.h"

#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace crevice;

namespace fs = std::filesystem;

TEST_CASE("memory sources find what was added, by exact path")
{
    MemorySources sources;
    sources.add("b.json", "B");
    sources.add("a.json", "A", "shown/a.json");
    REQUIRE(sources.find("a.json"));
    CHECK(sources.find("a.json")->text == "A");
    CHECK(sources.find("a.json")->name == "shown/a.json");
    CHECK(sources.find("a.json")->path == "a.json");
    CHECK(sources.find("b.json")->name == "b.json");
    CHECK_FALSE(sources.find("c.json"));
    CHECK_FALSE(sources.find(""));
    CHECK(sources.list() == std::vector<std::string>{"a.json", "b.json"});
}

TEST_CASE("adding a path again replaces its text and leaves the old one to its holders")
{
    MemorySources sources;
    sources.add("a.json", "old");
    const SourceRef old = sources.find("a.json");
    sources.add("a.json", "new");
    CHECK(sources.find("a.json")->text == "new");
    CHECK(old->text == "old");
    CHECK(sources.list().size() == 1);
}

TEST_CASE("a folder and a missing file are no texts")
{
    const TemporaryFolder folder("source_read");
    folder.write("empty.json", "");
    folder.write("zero.json", std::string("a\0b", 3));
    CHECK_FALSE(readFile(folder.path.string()));
    CHECK_FALSE(readFile((folder.path / "none.json").string()));
    CHECK(readFile((folder.path / "empty.json").string())->text.empty());
    CHECK(readFile((folder.path / "zero.json").string())->text == std::string("a\0b", 3));
    CHECK(readFile((folder.path / "zero.json").string())->path.empty());
}

TEST_CASE("an earlier layer hides a later one")
{
    MemorySources front, back;
    front.add("a", "front");
    back.add("a", "back");
    back.add("b", "back");
    const LayeredSources layers({&front, &back});
    CHECK(layers.find("a")->text == "front");
    CHECK(layers.find("b")->text == "back");
    CHECK_FALSE(layers.find("c"));
    CHECK(layers.list() == std::vector<std::string>{"a", "b"});
}

TEST_CASE("a relative path is seen from the folder of the file that writes it")
{
    CHECK(resolvePath("configs/a.json", "./b.frag") == "configs/b.frag");
    CHECK(resolvePath("configs/a.json", "../ssao/b.frag") == "ssao/b.frag");
    CHECK(resolvePath("a.json", "./b.frag") == "b.frag");
    CHECK(resolvePath("x/y/a.json", "../../b/./../c.frag") == "c.frag");
    CHECK(resolvePath("/home/me/a.json", "../b.json") == "/home/b.json");
    CHECK(resolvePath("./a.json", "./b.json") == "./b.json");
}

TEST_CASE("a path that is not relative stays as it is")
{
    CHECK(resolvePath("configs/a.json", "ssao/b.frag") == "ssao/b.frag");
    CHECK(resolvePath("configs/a.json", "/tmp/b.frag") == "/tmp/b.frag");
    CHECK(resolvePath("configs/a.json", ".hidden") == ".hidden");
}

TEST_CASE("a catalog path does not climb above its root, a path on disk may")
{
    CHECK(resolvePath("configs/a.json", "../../b.frag").empty());
    CHECK(resolvePath("a.json", "../b.frag").empty());
    CHECK(resolvePath("./a.json", "../b.frag") == "../b.frag");
    CHECK(resolvePath("../a.json", "../b.frag") == "../../b.frag");
    CHECK(fs::path(resolvePath("/a.json", "../b.frag")).lexically_normal() == "/b.frag");
}

TEST_CASE("UTF-8 characters are distinguished from bytes that only look like them")
{
    for (const std::string good :
         {"a", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x99\x82", "\xED\x9F\xBF"})
        CHECK(utf8Length(good, 0) == good.size());
    for (const std::string bad : {"\x80", "\xC0\xAF", "\xC3", "\xE0\x9F\xBF", "\xED\xA0\x80",
                                  "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xE2\x82"})
        CHECK(utf8Length(bad, 0) == 0);
    CHECK(utf8Prefix("a\xC3\xA4", 2) == "a");
    CHECK(utf8Prefix("a\xC3\xA4", 3) == "a\xC3\xA4");
}

TEST_CASE("a JSON string escapes what must be and stays UTF-8")
{
    CHECK(jsonString("a\"b\\c\n\t\x01") == R"("a\"b\\c\n\t\u0001")");
    CHECK(jsonString("\xC3\xA4\xFF") == "\"\xC3\xA4\xEF\xBF\xBD\"");
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

TEST_CASE("a pointer escapes '~' and '/'")
{
    CHECK(memberPointer("", "passes") == "/passes");
    CHECK(memberPointer("/passes", "a/b~c") == "/passes/a~1b~0c");
}
