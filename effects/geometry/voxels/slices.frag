#version 300 es
// SPDX-License-Identifier: MIT
// Which of sixteen slices of a box a surface lies in: four layers of four channels each, of which one is 1. Blended by
// the larger, a texel keeps all that was drawn. OpenGL ES 3.0 has no other way to write several voxels of a pixel.
precision highp float;

#include "geometry/shaders/material.glsl"

uniform highp int first_layer;

in vec3 place;
in vec2 uv;
layout(location = 0) out vec4 slices_0;
layout(location = 1) out vec4 slices_4;
layout(location = 2) out vec4 slices_8;
layout(location = 3) out vec4 slices_12;

void main()
{
    materialAlbedo(uv);
    int edge = first_layer / (RESOLUTION / 4);
    float along = edge == 0 ? place.x : edge == 1 ? place.y : place.z;
    int slice = int(floor(along)) - 4 * (first_layer - edge * (RESOLUTION / 4));
    if (slice < 0 || slice >= 16) discard;
    vec4 channel = vec4(equal(ivec4(slice & 3), ivec4(0, 1, 2, 3)));
    int layer = slice >> 2;
    slices_0 = layer == 0 ? channel : vec4(0.0);
    slices_4 = layer == 1 ? channel : vec4(0.0);
    slices_8 = layer == 2 ? channel : vec4(0.0);
    slices_12 = layer == 3 ? channel : vec4(0.0);
}
