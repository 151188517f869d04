#version 300 es
// SPDX-License-Identifier: MIT
// Forward lighting: the scene drawn once more and lit as it is drawn, with occlusion found before.
//
//   visibility  of the pixel, 1 open .. 0 blocked
//   color       sRGB, ready to show
//   DISPLAY     the lit picture with occlusion, without, or the occlusion alone
precision highp float;  // positions

#if SCENE_MATERIAL_AMBIENT
#define AMBIENT_BY_MATERIAL
#endif
#include "geometry/shaders/material.glsl"
#include "lighting/shaders/shade.glsl"
#include "lighting/shaders/srgb.glsl"

uniform vec2 viewport_size;
#if DISPLAY != DISPLAY_NO_AO
uniform mediump sampler2D visibility;
#endif

in vec3 point;
in vec3 facing;
in vec2 uv;

layout(location = 0) out vec4 color;

float openHere()
{
#if DISPLAY == DISPLAY_NO_AO
    return 1.0;
#else
    return texture(visibility, gl_FragCoord.xy / viewport_size).r;
#endif
}

void main()
{
    vec4 albedo = materialAlbedo(uv);
    float open = openHere();
#if DISPLAY == DISPLAY_AO_ONLY
    color = vec4(vec3(open), 1.0);
#else
    vec3 normal = materialNormal(point, planeOf(point), facing, uv);
#ifdef AMBIENT_BY_MATERIAL
    Surface s = Surface(point, normal, albedo.rgb, albedo.a, material_ambient);
#else
    Surface s = Surface(point, normal, albedo.rgb, albedo.a);
#endif
    color = vec4(srgbFromLinear(shade(s, open, 1.0)), 1.0);
#endif
}
