#version 300 es
// SPDX-License-Identifier: MIT
// The mean of BLUR_SIZE x BLUR_SIZE taps about each pixel.
//
//   ao           what is filtered, sampled linearly
//   ao_filtered  the mean
//
// The taps stand symmetrically about the pixel's centre. Where BLUR_SIZE is even they fall between
// pixels and linear sampling averages the neighbours: a tile of BLUR_SIZE noise values vanishes and the
// picture does not shift by half a pixel.
precision highp float;

uniform mediump sampler2D ao;

in vec2 uv;
layout(location = 0) out float ao_filtered;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    float first = -0.5 * float(BLUR_SIZE - 1);
    float sum = 0.0;
    for (int y = 0; y < BLUR_SIZE; ++y)
        for (int x = 0; x < BLUR_SIZE; ++x)
            sum += texture(ao, uv + (first + vec2(x, y)) * texel).r;
    ao_filtered = sum / float(BLUR_SIZE * BLUR_SIZE);
}
