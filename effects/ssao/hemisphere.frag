#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion by counting offsets, in the hemisphere over the surface, that lie behind what the
// camera sees.
//
//   surface         interface: point and normal in view space
//   kernel          SAMPLES offsets in the unit hemisphere about +z
//   rotation_noise  a tile of unit vectors, one rotation about the normal a pixel
//   ao              visibility, 1 open .. 0 blocked; 1 in the background
//
// [Filion, McNaughton 2008, "StarCraft II: Effects & Techniques"; Chapman 2013, "SSAO Tutorial"]
precision highp float;  // positions and depths; mediump bands

#include "common/tangent_frame.glsl"
#include "common/view_space.glsl"
#include <surface>
#include "ssao/occlusion_curve.glsl"
#include "ssao/range_check.glsl"

uniform vec3 kernel[SAMPLES];
uniform mediump sampler2D rotation_noise;
uniform float radius;
uniform float bias;

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    vec3 origin;
    if (!pointAt(uv, origin)) {
        ao = 1.0;
        return;
    }
    vec2 rotation = texture(rotation_noise, gl_FragCoord.xy / vec2(textureSize(rotation_noise, 0))).xy;
    vec3 normal_here = normalAt(uv);
    mat3 view_from_kernel = rotatedFrame(normal_here, rotation);

    float occlusion = 0.0;
    float known = 0.0;  // probes off the screen say nothing, either way
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 probe = origin + view_from_kernel * kernel[i] * radius;
        vec2 at;
        if (!uvFromView(probe, at)) continue;
        known += 1.0;
        vec3 seen;
        if (!pointAt(at, seen)) continue;
        // What lies in the tangent plane cannot occlude; without this a plane seen at a grazing angle
        // shades itself, since a texel's one depth stands for all of its slope.
        bool above = dot(seen - origin, normal_here) > bias;
        if (above && seen.z >= probe.z + bias) occlusion += rangeWeight(origin.z - seen.z, radius);
    }
    ao = visibilityOf(occlusion / max(known, 1.0));
}
