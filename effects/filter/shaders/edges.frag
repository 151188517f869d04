#version 300 es
// SPDX-License-Identifier: MIT
// Where a filter may cross from pixel to pixel.
//
//   surface  interface: view depth
//   edges    openness towards the pixel on the left and the one below, in the host's own picture: 1 is one surface, 0
//            an edge. The pixels on the right and above hold the other two.
//
// Two neighbours are one surface where their depths lie on a line with what follows on either side, so
// that floors at a grazing angle stay open. In perspective the reciprocal of depth is what is straight
// across the screen. Edges once for all passes are the idea of XeGTAO; that they compare four depths on a line is ours.
precision highp float;  // depths are compared

#define SURFACE_WITHOUT_NORMAL
#include "common/host_picture.glsl"
#include <surface>

uniform mediump sampler2D ao;
uniform float radius;
uniform float depth_cut;

in vec2 uv;
layout(location = 0) out vec2 edges;

// A depth and what is straight across the screen.
vec2 depthAt(vec2 at)
{
    float z = clamp(viewZAt(at), -1e15, -1e-15);
#if CAMERA_ORTHOGRAPHIC
    return vec2(1.0, z);
#else
    return vec2(z, 1.0 / z);
#endif
}

// Openness between `a` and `b`, which lie between `before` and `after`.
float opennessOf(float before, vec2 a, vec2 b, float after, float cut)
{
    float change = b.y - a.y;
    float error = min(abs(change - (a.y - before)), abs(change - (after - b.y)));
    return clamp((cut - error * a.x * b.x) / max(cut, 1e-30), 0.0, 1.0);
}

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    vec2 x = pictureFromHost(vec2(1.0, 0.0)) * texel;
    vec2 y = pictureFromHost(vec2(0.0, 1.0)) * texel;
    vec2 here = depthAt(uv);
    float cut = depth_cut * radius;
    edges = vec2(opennessOf(depthAt(uv - 2.0 * x).y, depthAt(uv - x), here, depthAt(uv + x).y, cut),
                 opennessOf(depthAt(uv - 2.0 * y).y, depthAt(uv - y), here, depthAt(uv + y).y, cut));
}
