#version 300 es
// SPDX-License-Identifier: MIT
// What surfaces that face or mirror each direction see of the surroundings: kMaps maps, one above the other.
//
//   surroundings  longitude by latitude, linear colour
//   reflections   likewise, kMaps of them
// [Karis 2013 - what a rough surface mirrors, as if seen from ahead; Walter et al. 2007 - GGX]
precision highp float;

#include "lighting/shaders/sphere_map.glsl"

uniform mediump sampler2D surroundings;

in vec2 uv;
layout(location = 0) out vec4 reflections;

// Of light from where the cosine to the mirrored direction is `facing`. About the half vector it is GGX's; a matte
// surface (alpha 0) reflects by the cosine alone.
float weightOf(float facing, float alpha)
{
    if (alpha == 0.0) return max(facing, 0.0);
    float half_cosine2 = 0.5 + 0.5 * facing;  // squared, between the normal and the half vector
    float shape = half_cosine2 * (alpha * alpha - 1.0) + 1.0;
    return max(facing, 0.0) / (shape * shape);
}

void main()
{
    float level = min(floor(uv.y * kMaps), kMaps - 1.0);
    vec2 place = vec2(uv.x, uv.y * kMaps - level);
    if (level == 0.0) {
        reflections = vec4(textureLod(surroundings, place, 0.0).rgb, 1.0);
        return;
    }
    float roughness = level / 3.0;
    float alpha = level == kMaps - 1.0 ? 0.0 : roughness * roughness;
    vec3 axis = directionAt(place);
    ivec2 size = textureSize(surroundings, 0);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < size.y; ++y) {
        float latitude = (float(y) + 0.5) / float(size.y);
        float area = cos((latitude - 0.5) * 3.1415927);
        for (int x = 0; x < size.x; ++x) {
            vec3 towards = directionAt(vec2((float(x) + 0.5) / float(size.x), latitude));
            float weight = area * weightOf(dot(axis, towards), alpha);
            sum += weight * vec4(texelFetch(surroundings, ivec2(x, y), 0).rgb, 1.0);
        }
    }
    reflections = vec4(sum.rgb / max(sum.a, 1e-6), 1.0);
}
