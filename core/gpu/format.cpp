// SPDX-License-Identifier: MIT
// The table of texture formats.
#include <crevice/device.h>

namespace crevice {

const std::vector<FormatInfo>& allFormats()
{
    constexpr double kHalf = 1.0 / (1 << 10);  // steps of numbers with 11 and 24 binary digits
    constexpr double kFloat = 1.0 / (1 << 23);
    constexpr double kHalfLeast = kHalf / (1 << 14);
    // What needs an extension: OpenGL ES 3.0 lists no floating-point format as colour-renderable.
    static const std::vector<FormatInfo> formats = {
        {Format::r8, "r8", FormatClass::unorm, 1, 1, true, true, 1.0 / 255, 0},
        {Format::rg8, "rg8", FormatClass::unorm, 2, 2, true, true, 1.0 / 255, 0},
        {Format::rgba8, "rgba8", FormatClass::unorm, 4, 4, true, true, 1.0 / 255, 0},
        {Format::rgb10_a2, "rgb10_a2", FormatClass::unorm, 4, 4, true, true, 1.0 / 1023, 0},
        {Format::r16f, "r16f", FormatClass::floating, 1, 2, false, true, kHalfLeast, kHalf},
        {Format::rg16f, "rg16f", FormatClass::floating, 2, 4, false, true, kHalfLeast, kHalf},
        {Format::rgba16f, "rgba16f", FormatClass::floating, 4, 8, false, true, kHalfLeast, kHalf},
        {Format::r32f, "r32f", FormatClass::floating, 1, 4, false, false, 0, kFloat},
        {Format::rg32f, "rg32f", FormatClass::floating, 2, 8, false, false, 0, kFloat},
        {Format::rgba32f, "rgba32f", FormatClass::floating, 4, 16, false, false, 0, kFloat},
        {Format::r11g11b10f, "r11g11b10f", FormatClass::floating, 3, 4, false, true, 0, 1.0 / 32},
        {Format::depth16, "depth16", FormatClass::depth, 1, 2, true, false, 1.0 / 0xffff, 0},
        {Format::depth24, "depth24", FormatClass::depth, 1, 4, true, false, 1.0 / 0xffffff, 0},
        {Format::depth32f, "depth32f", FormatClass::depth, 1, 4, true, false, 0, kFloat},
    };
    return formats;
}

const std::vector<std::string>& formatNames()
{
    static const std::vector<std::string> names = namesOf(allFormats());
    return names;
}

const FormatInfo& formatInfo(Format format)
{
    static const FormatInfo none = {
        Format::none, "none", FormatClass::none, 0, 0, false, false, 0, 0};
    for (const FormatInfo& info : allFormats())
        if (info.format == format) return info;
    return none;
}

Format formatFromName(std::string_view name)
{
    const FormatInfo* found = findNamed(allFormats(), name);
    return found ? found->format : Format::none;
}

}  // namespace crevice
