#version 300 es
// SPDX-License-Identifier: MIT
// A 3x3 mean that goes from pixel to pixel only where no edge lies between them.
//
//   edges        see edges.frag
//   ao           what is filtered
//   ao_filtered  the weighted mean
//   CENTER       weight of the pixel itself, in either direction, where a neighbour has 1
//
// After one pass with CENTER 2 and one with CENTER 0 no noise is left that repeats every four pixels: the
// first halves what the second takes out, and the first takes out what the second would turn around: 1 2 1 times 1 0 1
// are the taps of bilateral_normal. Ours; passes over packed edges are XeGTAO's.
precision mediump float;

#include "common/host_picture.glsl"

uniform mediump sampler2D ao;
uniform mediump sampler2D edges;

in highp vec2 uv;
layout(location = 0) out float ao_filtered;

vec2 tapAt(highp vec2 at, float weight)
{
    return weight * vec2(texture(ao, at).r, 1.0);
}

void main()
{
    highp vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    highp vec2 x = pictureFromHost(vec2(1.0, 0.0)) * texel;
    highp vec2 y = pictureFromHost(vec2(0.0, 1.0)) * texel;
    highp vec2 diagonal = x + y;
    highp vec2 other = x - y;
    vec2 here = texture(edges, uv).rg;
    vec2 right = texture(edges, uv + x).rg;
    vec2 above = texture(edges, uv + y).rg;
    vec2 across = texture(edges, uv + diagonal).rg;

    // Towards a corner the way leads over either neighbour, whichever is more open.
    const float own = max(CENTER * CENTER, 0.01);  // so that a pixel with four edges keeps what it has
    vec2 sum = tapAt(uv, own);
    sum += tapAt(uv - diagonal, here.r * texture(edges, uv - x).g);
    sum += tapAt(uv + other, right.r * right.g);
    sum += tapAt(uv - other, above.g * above.r);
    sum += tapAt(uv + diagonal, max(right.r * across.g, above.g * across.r));
    if (CENTER > 0.0) {
        sum += tapAt(uv - x, CENTER * here.r) + tapAt(uv + x, CENTER * right.r);
        sum += tapAt(uv - y, CENTER * here.g) + tapAt(uv + y, CENTER * above.g);
    }
    ao_filtered = sum.x / sum.y;
}
