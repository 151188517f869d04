// SPDX-License-Identifier: MIT
// Which texel of a texture a place in it names.

#include "common/host_picture.glsl"

// At half the size pixel centres lie where four texels meet. There rounding would decide, pixel by pixel and for depth
// and normals apart; so the texel is a little to one side, by more than the error of a uv and less than any distance
// that matters: of 8192 texels the last bit of a uv is 1/2048 of one.
const highp float kTie = 1.0 / 256.0;

// The texel at `at`, in the host's own picture. Ours: the side changes after every other row and column, so that half
// of a picture is no shift of it; and is one for all of a row or column, so that edges along them have no teeth.
highp vec2 hostTexelUnder(highp vec2 at)
{
    return floor(at + kTie * (8.0 * fract(0.25 * at + 0.125) - 4.0));  // from tie to tie -3, -1, 1, 3 of it
}

// The texel at `at`, counted from texel `first` of a texture of `size`, with as many more than the view on each side.
highp ivec2 texelUnder(highp vec2 at, highp vec2 first, highp vec2 size)
{
#if CAMERA_TURNED
    highp vec2 view = size - 2.0 * first;
    highp vec2 texel = pixelFromHost(hostTexelUnder(hostPixel(at, view)) + 0.5, view) - 0.5;
#else
    highp vec2 texel = hostTexelUnder(at);
#endif
    return ivec2(clamp(texel + first, vec2(0.0), size - 1.0));
}

// The texel at `place`, 0..1 over a texture of `size` texels.
highp ivec2 texelAt(highp vec2 place, highp vec2 size)
{
    return texelUnder(place * size, vec2(0.0), size);
}
