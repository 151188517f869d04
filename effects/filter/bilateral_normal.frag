#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a separable mean over four pixels that stops at edges in depth and in normals.
//
//   surface      interface: point and normal in view space
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged in the background and where no neighbour counts
//   AXIS         vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// Five taps, the outer ones by half: on a plane each of four neighbouring columns counts alike, so that
// noise which repeats every four pixels vanishes, and the picture does not shift. A tap counts less the
// farther it lies off the pixel's tangent plane and the more its normal turns.
// [Tomasi, Manduchi 1998, "Bilateral Filtering for Gray and Color Images"]
precision highp float;  // positions are compared

#include <surface>

uniform mediump sampler2D ao;
uniform float radius;
uniform float depth_cut;
uniform float normal_cut;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// The pixel's tangent plane and normal, divided by the cuts.
struct Here {
    vec3 point;
    vec3 plane;
    vec3 normal;
    float whole;  // weight of a tap that is in the plane and parallel
};

// What the tap adds to the weighted sum, and its weight.
vec2 tapAt(vec2 at, Here here)
{
    vec3 point;
    bool known = pointAt(at, point);
    float weight = here.whole - abs(dot(point - here.point, here.plane)) + dot(normalAt(at), here.normal);
    weight = known ? clamp(weight, 0.0, 1.0) : 0.0;
    return weight * vec2(texture(ao, at).r, 1.0);
}

void main()
{
    vec2 texel = AXIS / vec2(textureSize(ao, 0));
    vec2 sum = vec2(texture(ao, uv).r, 1.0);
    Here here;
    if (pointAt(uv, here.point)) {
        vec3 normal_here = normalAt(uv);
        float cut = depth_cut * radius;
        float per_length = 1.0 / max(cut, 1e-30);
        here.plane = normal_here * per_length;
        here.normal = normal_here / normal_cut;
        here.whole = cut * per_length - 1.0 / normal_cut;
        sum += tapAt(uv - texel, here) + tapAt(uv + texel, here);
        sum += 0.5 * (tapAt(uv - 2.0 * texel, here) + tapAt(uv + 2.0 * texel, here));
    }
    ao_filtered = sum.x / sum.y;
}
