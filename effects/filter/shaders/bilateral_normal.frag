#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a separable mean over four pixels that stops at steps and edges.
//
//   surface      interface: point and normal in view space
//   normal_low   with NEIGHBOUR_NORMALS: those normals, read instead
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged in the background and where no neighbour counts
//   AXIS         vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// Five taps, the outer ones by half: on a plane each of four neighbouring columns counts alike, so that
// noise which repeats every four pixels vanishes, and the picture does not shift. The taps are ours, as is all of
// near_plane.glsl but the idea, weights by what is seen: docs/methods/filters.md has its error and cost.
// [Tomasi, Manduchi 1998, "Bilateral Filtering for Gray and Color Images"]
precision highp float;  // positions are compared

#include "common/host_picture.glsl"
#include "filter/shaders/near_plane.glsl"

uniform mediump sampler2D ao;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// What the tap adds to the weighted sum, and its weight.
vec2 tapAt(vec2 at, Here here)
{
    return nearnessOf(at, here) * vec2(texture(ao, at).r, 1.0);
}

vec3 ownNormal()
{
#ifdef NEIGHBOUR_NORMALS
    return lowNormalAt(uv);
#else
    return normalAt(uv);
#endif
}

void main()
{
    vec2 texel = pictureFromHost(AXIS) / vec2(textureSize(ao, 0));
    vec2 sum = vec2(texture(ao, uv).r, 1.0);
    Here here;
    if (hereAt(uv, ownNormal(), here)) {
        sum += tapAt(uv - texel, here) + tapAt(uv + texel, here);
        sum += 0.5 * (tapAt(uv - 2.0 * texel, here) + tapAt(uv + 2.0 * texel, here));
    }
    ao_filtered = sum.x / sum.y;
}
