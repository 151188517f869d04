#version 300 es
// SPDX-License-Identifier: MIT
// What surfaces reflect of the lights that reach them, in every direction alike.
//
//   surface  interface: point and normal in view space
//   albedo   linear colour
//   direct   linear colour; 0 in the background
precision highp float;  // positions

#include "common/guard_band.glsl"
#include <surface>
#if SCENE_LIGHTS > 0
#include "lighting/shaders/light.glsl"
#endif

uniform mediump sampler2D albedo;

in vec2 uv;
layout(location = 0) out vec4 direct;

void main()
{
    vec3 light = vec3(0.0);
#if SCENE_LIGHTS > 0
    vec3 point;
    if (viewPosition(uv, point)) {
        vec3 normal_here = normalAt(uv);
        for (int i = 0; i < SCENE_LIGHTS; ++i) {
            vec3 direction;
            vec3 arriving = lightFrom(i, point, direction);
            light += arriving * max(dot(normal_here, direction), 0.0);
        }
    }
#endif
    highp ivec2 texel = texelInGuardBand(uv, vec2(textureSize(albedo, 0)));
    direct = vec4(light * texelFetch(albedo, texel, 0).rgb, 1.0);
}
