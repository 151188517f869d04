// SPDX-License-Identifier: MIT
// Texture formats and the facts about them that need no GL. JSON writes them in lower case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace crevice {

enum class Format {
    none,
    r8,
    rg8,
    rgba8,
    rgb10_a2,
    r16f,
    rg16f,
    rgba16f,
    r32f,
    rg32f,
    rgba32f,
    r11g11b10f,
    depth16,
    depth24,
    depth32f,
};

constexpr int kFormatCount = 15;

enum class FormatClass { none, unorm, floating, depth };

/// What holds for a format on every device.
struct FormatInfo {
    Format format;
    const char* name;  ///< The JSON spelling.
    FormatClass format_class;
    int channels;
    int bytes;       ///< A texel; depth24 counts 4.
    bool core_renderable;  ///< OpenGL ES 3.0 renders to it with no extension.
    bool filterable;       ///< ... and reads it with the filter linear; else that reads black
                           ///< (table 3.13, section 3.8.13).
    double absolute_step;  ///< Between neighbouring values: this much,
    double relative_step;  ///< and this share of the value, at most.
};

/// Facts about `format`; Format::none has zero channels and bytes.
const FormatInfo& formatInfo(Format format);

/// The format of that JSON name; Format::none when there is none.
Format formatFromName(std::string_view name);

/// The JSON spellings of all formats but none, in the order of the enum.
const std::vector<std::string>& formatNames();

/// All formats but none, in the order of the enum.
const std::vector<FormatInfo>& allFormats();

}  // namespace crevice
