// SPDX-License-Identifier: MIT
// Images in CPU memory: 32-bit floats, row 0 at the bottom as GL has it.
#pragma once

#include <cstddef>
#include <vector>

namespace crevice {

/// Width and height in pixels.
struct Extent {
    int width = 0;
    int height = 0;

    bool operator==(const Extent& other) const
    {
        return width == other.width && height == other.height;
    }
    bool operator!=(const Extent& other) const { return !(*this == other); }
};

/// A plain float image; `pixels` holds channels next to each other, rows from the bottom up.
struct Image {
    Extent extent;
    int channels = 0;
    std::vector<float> pixels;

    Image() = default;
    Image(Extent size, int channel_count, float value = 0.0f)
        : extent(size),
          channels(channel_count),
          pixels(static_cast<std::size_t>(size.width) * size.height * channel_count, value)
    {
    }

    /// Requires 0 <= x < width, 0 <= y < height, 0 <= channel < channels.
    float& at(int x, int y, int channel = 0) { return pixels[index(x, y, channel)]; }
    float at(int x, int y, int channel = 0) const { return pixels[index(x, y, channel)]; }

private:
    std::size_t index(int x, int y, int channel) const
    {
        return (static_cast<std::size_t>(y) * extent.width + x) * channels + channel;
    }
};

}  // namespace crevice
