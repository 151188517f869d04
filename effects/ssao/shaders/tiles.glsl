// SPDX-License-Identifier: MIT
// The view's pixels in 4x4 tiles of every fourth pixel each. Where the view is not a multiple of four, the
// last texels of some tiles stand for no pixel.

#include "common/guard_band.glsl"

uniform highp sampler2D stored_depth;  // as the geometry pass wrote it; it has the view's size

// Of the view, without its guard band.
highp ivec2 viewPixels()
{
    return ivec2(viewSizeIn(vec2(textureSize(stored_depth, 0))));
}

highp vec2 uvOfPixel(highp ivec2 pixel)
{
    return (vec2(pixel) + 0.5) / vec2(viewPixels());
}

// The pixel that a texel of the tiles stands for; `tile` is the size of one.
highp ivec2 pixelOfTexel(highp ivec2 texel, highp ivec2 tile)
{
    return 4 * (texel % tile) + texel / tile;
}

highp ivec2 texelOfPixel(highp ivec2 pixel, highp ivec2 tile)
{
    return pixel % 4 * tile + pixel / 4;
}
