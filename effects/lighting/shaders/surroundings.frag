#version 300 es
// SPDX-License-Identifier: MIT
// The light from all around as a small map: means of a picture's texels, or a gradient where there is no picture.
//
//   environment   longitude by latitude, linear colour; a single texel is no picture
//   surroundings  likewise
precision highp float;

#include "lighting/shaders/sphere_map.glsl"

uniform mediump sampler2D environment;
uniform vec2 viewport_size;
uniform vec3 sky_color;
uniform vec3 ground_color;

in vec2 uv;
layout(location = 0) out vec4 surroundings;

const int kAcross = 16;  // reads along each side of a texel

void main()
{
    if (textureSize(environment, 0).x == 1) {
        float above = smoothstep(-0.3, 0.3, directionAt(uv).y);
        surroundings = vec4(mix(ground_color, sky_color, above), 1.0);
        return;
    }
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kAcross * kAcross; ++i) {
        vec2 within = (vec2(i % kAcross, i / kAcross) + 0.5) / float(kAcross) - 0.5;
        sum += min(texture(environment, uv + within / viewport_size).rgb, vec3(60000.0));
    }
    surroundings = vec4(sum / float(kAcross * kAcross), 1.0);
}
