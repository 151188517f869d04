#version 300 es
// SPDX-License-Identifier: MIT
// Deferred lighting of what a geometry module drew.
//
//   surface      interface: point and normal in view space
//   albedo       linear colour; alpha is the strength of the highlight
//   ambient_factor  with AMBIENT_BY_MATERIAL: the material's share of the ambient light
//   visibility   1 open .. 0 blocked
//   indirect_filtered  with INDIRECT: linear colour that the surface gets from its occluders
//   bent_normal  with SPECULAR_OCCLUSION_BENT, where there is one: mean open direction, view space, n * 0.5 + 0.5
//   color        sRGB, ready to show; alpha 0 in a transparent background
//   DISPLAY      the lit picture with occlusion, without, or the occlusion alone
precision highp float;  // positions

#if DISPLAY == DISPLAY_AO_ONLY
uniform highp sampler2D visibility;
#else
#if SCENE_LIGHTS == 0
#define SURFACE_WITHOUT_NORMAL
#endif
#if SCENE_MATERIAL_AMBIENT && defined AMBIENT_FACTOR_STEP  // there is such a target
#define AMBIENT_BY_MATERIAL
uniform mediump sampler2D ambient_factor;
#endif
#include "common/guard_band.glsl"
#include "lighting/shaders/shade.glsl"
#include "lighting/shaders/display.glsl"
#include <surface>

uniform mediump sampler2D albedo;
#if BACKGROUND == BACKGROUND_COLOR
uniform vec3 background_color;
#endif
#ifndef INDIRECT  // the switch of filter/indirect, which a config may lack
#define INDIRECT 0
#endif
#if DISPLAY == DISPLAY_LIT
uniform highp sampler2D visibility;
#if INDIRECT
uniform mediump sampler2D indirect_filtered;
#endif
#if HIGHLIGHTS && SPECULAR_OCCLUSION != SPECULAR_OCCLUSION_NONE
#define GLOSS_OCCLUDED
#include "lighting/shaders/caps.glsl"
#if SPECULAR_OCCLUSION == SPECULAR_OCCLUSION_BENT && defined BENT_NORMAL_STEP  // there is such a target
uniform mediump sampler2D bent_normal;
#endif
#endif
#endif
#endif

in vec2 uv;
layout(location = 0) out vec4 color;

#ifdef GLOSS_OCCLUDED
float glossOpenAt(Surface s, float open)
{
    vec3 to_eye = toEye(s.point);
#if SPECULAR_OCCLUSION == SPECULAR_OCCLUSION_AO
    return glossOpen(open, clamp(dot(s.normal, to_eye), 0.0, 1.0), specular_power);
#else
    vec3 bent = s.normal;
#ifdef BENT_NORMAL_STEP
    bent = texture(bent_normal, uv).xyz * 2.0 - 1.0;
    bent /= max(length(bent), 1e-6);
#endif
    return glossOpen(open, bent, s.normal, reflect(-to_eye, s.normal), specular_power);
#endif
}
#endif

#if DISPLAY != DISPLAY_AO_ONLY
vec4 background()
{
#if BACKGROUND == BACKGROUND_COLOR
    return vec4(srgbFromLinear(background_color), 1.0);
#else
    return vec4(0.0);
#endif
}
#endif

void main()
{
#if DISPLAY == DISPLAY_AO_ONLY
    color = vec4(vec3(texture(visibility, uv).r), 1.0);
#else
    Surface s;
    if (!viewPosition(uv, s.point)) {
        color = background();
        return;
    }
    highp ivec2 texel = texelInGuardBand(uv, vec2(textureSize(albedo, 0)));
    vec4 stored = texelFetch(albedo, texel, 0);
    s.albedo = stored.rgb;
    s.gloss = stored.a;
#ifdef AMBIENT_BY_MATERIAL
    s.ambient = texelFetch(ambient_factor, texel, 0).r;
#endif
#if SCENE_LIGHTS > 0
    s.normal = normalAt(uv);
#endif
#if DISPLAY == DISPLAY_LIT
    float open = shownOpen(texture(visibility, uv).r, length(s.point));
#else
    float open = 1.0;
#endif
#ifdef GLOSS_OCCLUDED
    float gloss_open = glossOpenAt(s, open);
#else
    float gloss_open = 1.0;
#endif
    vec3 light = shade(s, open, gloss_open);
#if DISPLAY == DISPLAY_LIT && INDIRECT
    light += s.albedo * texture(indirect_filtered, uv).rgb;
#endif
    color = vec4(displayed(light), 1.0);
#endif
}
