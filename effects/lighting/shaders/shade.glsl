// SPDX-License-Identifier: MIT
// Light at a point, and what occlusion does to it.
//
//   reflection   interface: what a surface does with light (lighting/shaders/blinn_phong.glsl)
//   AO_ON        whether visibility dims the ambient light or everything
//   MULTI_BOUNCE   light that bounces in corners, so that bright and coloured ones are less dark
//   AMBIENT_BY_MATERIAL  defined where materials differ in the ambient light that they reflect
//
// [Jimenez et al. 2016 - bounces]

uniform vec3 ambient_light;
uniform float ambient;
uniform float ao_strength;
uniform float ao_floor;
uniform float ao_fade;
uniform vec3 ao_color;
#if SCENE_LIGHTS > 0
#include "lighting/shaders/light.glsl"
#endif

// A point on a surface, in view space.
struct Surface {
    highp vec3 point;
    highp vec3 normal;  // unit length
    vec3 albedo;
    float gloss;        // strength of its highlights
#ifdef AMBIENT_BY_MATERIAL
    float ambient;      // share of the ambient light that it reflects
#endif
};

// The unit vector to the eye.
highp vec3 toEye(highp vec3 point)
{
#if CAMERA_ORTHOGRAPHIC
    return vec3(0.0, 0.0, 1.0);
#else
    return -normalize(point);
#endif
}

// The visibility to show where it is `open`, of a surface that far away: with `ao_fade` 0 the same at any distance.
float shownOpen(float open, highp float distance)
{
    float faded = ao_fade > 0.0 ? clamp(2.0 * distance / ao_fade - 1.0, 0.0, 1.0) : 0.0;
    return max(mix(1.0, open, ao_strength * (1.0 - faded)), ao_floor);
}

// The ambient light that reaches a place of visibility `open`, where surfaces of that albedo throw light
// at each other. A cubic fitted to ray-traced scenes.
vec3 ambientOpen(float open, vec3 albedo)
{
#if MULTI_BOUNCE
    vec3 a = 2.0404 * albedo - 0.3324;
    vec3 b = -4.7951 * albedo + 0.6417;
    vec3 c = 2.7552 * albedo + 0.6903;
    vec3 reached = max(vec3(open), ((open * a + b) * open + c) * open);
#else
    vec3 reached = vec3(open);
#endif
    return mix(ao_color, vec3(1.0), reached);
}

#include <reflection>

#if SCENE_LIGHTS > 0
vec3 litBy(int i, Reflecting r, Surface s, float gloss_open)
{
    highp vec3 direction;
    vec3 light = lightFrom(i, s.point, direction);
    return light * reflectedFrom(r, s, gloss_open, direction);
}
#endif

// Linear light from the surface towards the eye. `gloss_open` dims the highlights alone.
vec3 shade(Surface s, float open, float gloss_open)
{
    Reflecting r = reflectingOf(s);
    vec3 light = reflectedAround(r, s, open);
#ifdef AMBIENT_BY_MATERIAL
    light *= s.ambient;
#endif
#if SCENE_LIGHTS > 0
    vec3 direct = vec3(0.0);
    // The first are written out: software renderers are slow at uniforms that a counter picks.
#define LIT_BY(i) if (i < SCENE_LIGHTS) direct += litBy(i, r, s, gloss_open)
    LIT_BY(0);
    LIT_BY(1);
    LIT_BY(2);
    LIT_BY(3);
    for (int i = 4; i < SCENE_LIGHTS; ++i) direct += litBy(i, r, s, gloss_open);
#if AO_ON == AO_ON_EVERYTHING
    direct *= open;
#endif
    light += direct;
#endif
    return withOwnLight(s, light);
}
