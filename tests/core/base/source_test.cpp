// SPDX-License-Identifier: MIT
// Sets of texts and the paths between them.
#include <crevice/source.h>

#include "core/base/text.h"

#include "tests/support/catch.h"

#include <filesystem>

using namespace crevice;

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
