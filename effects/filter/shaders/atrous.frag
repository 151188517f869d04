#version 300 es
// SPDX-License-Identifier: MIT
// One level of an edge-avoiding wavelet: 3x3 taps STEP pixels apart, that stop at steps and edges.
//
//   surface      interface: point and normal in view space
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged in the background and where no neighbour counts
//   STEP         distance between taps in pixels; doubles from level to level
//
// With the hat 1 2 1 in either direction the first two levels let no noise pass that repeats every four
// pixels. The paper takes 5x5 taps of a cubic spline, 1 4 6 4 1 over 16, at three times the cost.
// [Dammertz et al. 2010, "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination
// Filtering"]
precision highp float;  // positions are compared

#include "filter/shaders/near_plane.glsl"

uniform mediump sampler2D ao;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// What the tap adds to the weighted sum, and its weight.
vec2 tapAt(vec2 at, Here here)
{
    return nearnessOf(at, here) * vec2(texture(ao, at).r, 1.0);
}

void main()
{
    vec2 texel = STEP / vec2(textureSize(ao, 0));
    vec2 other = vec2(texel.x, -texel.y);
    vec2 x = vec2(texel.x, 0.0);
    vec2 y = vec2(0.0, texel.y);
    vec2 sum = 4.0 * vec2(texture(ao, uv).r, 1.0);
    Here here;
    if (hereAt(uv, normalAt(uv), here)) {
        sum += 2.0 * (tapAt(uv - x, here) + tapAt(uv + x, here));
        sum += 2.0 * (tapAt(uv - y, here) + tapAt(uv + y, here));
        sum += tapAt(uv - texel, here) + tapAt(uv + texel, here);
        sum += tapAt(uv - other, here) + tapAt(uv + other, here);
    }
    ao_filtered = sum.x / sum.y;
}
