#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a mean over four pixels of light that stops at steps and edges: what filter/bilateral_normal
// does to occlusion.
//
//   surface            interface: point and normal in view space
//   indirect           linear colour
//   indirect_filtered  the weighted mean
//   AXIS               vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// [Tomasi, Manduchi 1998, "Bilateral Filtering for Gray and Color Images"]
precision highp float;  // positions are compared

#include "common/host_picture.glsl"
#include "filter/shaders/near_plane.glsl"

uniform mediump sampler2D indirect;

in vec2 uv;
layout(location = 0) out vec4 indirect_filtered;

// What the tap adds to the weighted sum, and its weight.
vec4 tapAt(vec2 at, Here here)
{
    return nearnessOf(at, here) * vec4(texture(indirect, at).rgb, 1.0);
}

void main()
{
    vec2 texel = pictureFromHost(AXIS) / vec2(textureSize(indirect, 0));
    vec4 sum = vec4(texture(indirect, uv).rgb, 1.0);
    Here here;
    if (hereAt(uv, normalAt(uv), here)) {
        sum += tapAt(uv - texel, here) + tapAt(uv + texel, here);
        sum += 0.5 * (tapAt(uv - 2.0 * texel, here) + tapAt(uv + 2.0 * texel, here));
    }
    indirect_filtered = vec4(sum.rgb / sum.a, 1.0);
}
