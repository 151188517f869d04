// SPDX-License-Identifier: MIT
// How GL spells each format, and pixels in the form in which GL takes them.
#pragma once

#include <crevice/device.h>
#include <crevice/image.h>

#include "backends/gl/api.h"

#include <cstdint>
#include <vector>

namespace crevice {

/// What glTexStorage2D and glTexSubImage2D call a format.
struct GlFormat {
    Format format;
    GLenum internal;
    GLenum upload_format;
    GLenum upload_type;
};

/// Requires a format that is not none.
const GlFormat& glFormat(Format format);

/// Gives the bound GL_TEXTURE_2D one level of that size, nearest and clamped for hosts that bind no
/// sampler object. Its content is undefined. Errors stay pending.
void allocateTexture(const GlApi& gl, GLenum internal, Extent extent, int depth = 0,
                     int levels = 1);

/// An image's pixels as uploaded to `format`: tightly packed rows. Channels that the image lacks
/// are 0, alpha 1; those that the format lacks are dropped. What a normalised format cannot hold
/// is clamped to 0..1, NaN to 0.
std::vector<std::uint8_t> packPixels(const Image& image, Format format);

}  // namespace crevice
