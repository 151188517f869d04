// SPDX-License-Identifier: MIT
// Texture formats: the table is whole and true to OpenGL ES 3.0.
#include <crevice/device.h>

#include "tests/support/catch.h"

#include <set>

using namespace crevice;

TEST_CASE("every format but none is in the table once, in the order of the enum", "[format]")
{
    REQUIRE(allFormats().size() == kFormatCount - 1);
    for (std::size_t i = 0; i < allFormats().size(); ++i)
        CHECK(static_cast<std::size_t>(allFormats()[i].format) == i + 1);
}

TEST_CASE("a format's name leads back to it", "[format]")
{
    std::set<std::string_view> names;
    for (const FormatInfo& info : allFormats()) {
        CHECK(formatFromName(info.name) == info.format);
        CHECK(&formatInfo(info.format) == &info);
        CHECK(names.insert(info.name).second);
    }
}

TEST_CASE("no other word names a format", "[format]")
{
    for (const char* name : {"", "none", "RGBA8", "rgba", "rgba8 ", "depth"})
        CHECK(formatFromName(name) == Format::none);
    CHECK(formatInfo(Format::none).channels == 0);
    CHECK(formatInfo(Format::none).bytes == 0);
}

TEST_CASE("only normalised and depth formats render without an extension", "[format]")
{
    for (const FormatInfo& info : allFormats()) {
        INFO(info.name);
        CHECK(info.core_renderable == (info.format_class != FormatClass::floating));
        CHECK((info.format_class == FormatClass::depth) ==
              (std::string_view(info.name).substr(0, 5) == "depth"));
    }
}

TEST_CASE("a texel's bytes hold its channels", "[format]")
{
    CHECK(formatInfo(Format::rgba8).bytes == 4);
    CHECK(formatInfo(Format::rgb10_a2).bytes == 4);
    CHECK(formatInfo(Format::r11g11b10f).bytes == 4);
    CHECK(formatInfo(Format::depth24).bytes == 4);
    CHECK(formatInfo(Format::rgba16f).bytes == 8);
    CHECK(formatInfo(Format::rgba32f).bytes == 16);
    for (const FormatInfo& info : allFormats()) CHECK(info.bytes >= info.channels);
}
