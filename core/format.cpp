// SPDX-License-Identifier: MIT
// The table of texture formats.
#include "core/format.h"

namespace crevice {

const std::vector<FormatInfo>& allFormats()
{
    // What needs an extension: OpenGL ES 3.0 lists no floating-point format as colour-renderable.
    static const std::vector<FormatInfo> formats = {
        {Format::r8, "r8", FormatClass::unorm, 1, 1, true},
        {Format::rg8, "rg8", FormatClass::unorm, 2, 2, true},
        {Format::rgba8, "rgba8", FormatClass::unorm, 4, 4, true},
        {Format::rgb10_a2, "rgb10_a2", FormatClass::unorm, 4, 4, true},
        {Format::r16f, "r16f", FormatClass::floating, 1, 2, false},
        {Format::rg16f, "rg16f", FormatClass::floating, 2, 4, false},
        {Format::rgba16f, "rgba16f", FormatClass::floating, 4, 8, false},
        {Format::r32f, "r32f", FormatClass::floating, 1, 4, false},
        {Format::rg32f, "rg32f", FormatClass::floating, 2, 8, false},
        {Format::rgba32f, "rgba32f", FormatClass::floating, 4, 16, false},
        {Format::r11g11b10f, "r11g11b10f", FormatClass::floating, 3, 4, false},
        {Format::depth16, "depth16", FormatClass::depth, 1, 2, true},
        {Format::depth24, "depth24", FormatClass::depth, 1, 4, true},
        {Format::depth32f, "depth32f", FormatClass::depth, 1, 4, true},
    };
    return formats;
}

const FormatInfo& formatInfo(Format format)
{
    static const FormatInfo none = {Format::none, "none", FormatClass::none, 0, 0, false};
    for (const FormatInfo& info : allFormats())
        if (info.format == format) return info;
    return none;
}

Format formatFromName(std::string_view name)
{
    for (const FormatInfo& info : allFormats())
        if (name == info.name) return info.format;
    return Format::none;
}

}  // namespace crevice
