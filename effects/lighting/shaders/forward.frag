#version 300 es
// SPDX-License-Identifier: MIT
// Forward lighting: the scene drawn once more and lit as it is drawn, with occlusion found before.
//
//   visibility  of the pixel, 1 open .. 0 blocked
//   color       sRGB, ready to show; with BLENDED times alpha
//   DISPLAY     the lit picture with occlusion, without, or the occlusion alone
//   BLENDED     defined for what is seen through, which has no occlusion and is hidden by what is not (`surface`)
precision highp float;  // positions

#if SCENE_MATERIAL_AMBIENT
#define AMBIENT_BY_MATERIAL
#endif
in vec3 point;
in vec3 facing;
in vec2 uv;

#include "geometry/shaders/material.glsl"
#include "lighting/shaders/shade.glsl"
#include "lighting/shaders/display.glsl"
#ifdef BLENDED
#define SURFACE_WITHOUT_NORMAL
#include <surface>
#endif

uniform vec2 viewport_size;
#if DISPLAY != DISPLAY_NO_AO && !defined BLENDED
#define OCCLUDED
uniform mediump sampler2D visibility;
#endif

layout(location = 0) out vec4 color;

float openHere()
{
#ifdef OCCLUDED
    return texture(visibility, gl_FragCoord.xy / viewport_size).r;
#else
    return 1.0;
#endif
}

void main()
{
#ifdef BLENDED
    vec3 solid;
    if (viewPosition(gl_FragCoord.xy / viewport_size, solid) && solid.z > point.z) discard;
#endif
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
#ifdef OCCLUDED
    open = shownOpen(open, length(point));
#endif
    color = vec4(displayed(shade(s, open, 1.0)), 1.0);
#ifdef BLENDED
    color *= materialAlpha(uv);
#endif
#endif
}
