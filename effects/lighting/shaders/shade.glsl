// SPDX-License-Identifier: MIT
// Light at a point: ambient, diffuse, highlights; and what occlusion does to each.
//
//   REFLECTION     lambert has no highlights; phong measures them at the mirrored light, blinn_phong
//                  halfway between light and eye
//   AO_ON          whether visibility dims the ambient light or everything
//   MULTI_BOUNCE   light that bounces in corners, so that bright and coloured ones are less dark
//   AMBIENT_BY_MATERIAL  defined where materials differ in the ambient light that they reflect
//
// [Lambert 1760; Phong 1975; Blinn 1977; Jimenez et al. 2016 - bounces]

#if SCENE_LIGHTS > 0 && SCENE_SPECULAR && REFLECTION != REFLECTION_LAMBERT
#define HIGHLIGHTS 1
#else
#define HIGHLIGHTS 0
#endif

uniform vec3 ambient_light;
uniform float ambient;
#if SCENE_LIGHTS > 0
#include "lighting/shaders/light.glsl"
#endif
#if HIGHLIGHTS
uniform float specular_power;
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

#if HIGHLIGHTS
float highlight(highp vec3 normal, highp vec3 to_light, highp vec3 to_eye)
{
#if REFLECTION == REFLECTION_PHONG
    highp float facing = dot(reflect(-to_light, normal), to_eye);
#else
    highp vec3 halfway = to_light + to_eye;
    highp float facing = dot(normal, halfway / max(length(halfway), 1e-20));
#endif
    return facing > 0.0 ? pow(facing, specular_power) : 0.0;
}
#endif

#if SCENE_LIGHTS > 0
vec3 litBy(int i, Surface s, float gloss_open)
{
    highp vec3 direction;
    vec3 light = lightFrom(i, s.point, direction);
    vec3 reflected = s.albedo * max(dot(s.normal, direction), 0.0);
#if HIGHLIGHTS
    reflected += s.gloss * gloss_open * highlight(s.normal, direction, toEye(s.point));
#endif
    return light * reflected;
}
#endif

// The ambient light that reaches a place of visibility `open`, where surfaces of that albedo throw light
// at each other. A cubic fitted to ray-traced scenes.
vec3 ambientOpen(float open, vec3 albedo)
{
#if MULTI_BOUNCE
    vec3 a = 2.0404 * albedo - 0.3324;
    vec3 b = -4.7951 * albedo + 0.6417;
    vec3 c = 2.7552 * albedo + 0.6903;
    return max(vec3(open), ((open * a + b) * open + c) * open);
#else
    return vec3(open);
#endif
}

// Linear light from the surface towards the eye. `gloss_open` dims the highlights alone.
vec3 shade(Surface s, float open, float gloss_open)
{
    vec3 light = s.albedo * ambient_light * ambient * ambientOpen(open, s.albedo);
#ifdef AMBIENT_BY_MATERIAL
    light *= s.ambient;
#endif
#if SCENE_LIGHTS > 0
    vec3 direct = vec3(0.0);
    // The first are written out: software renderers are slow at uniforms that a counter picks.
#define LIT_BY(i) if (i < SCENE_LIGHTS) direct += litBy(i, s, gloss_open)
    LIT_BY(0);
    LIT_BY(1);
    LIT_BY(2);
    LIT_BY(3);
    for (int i = 4; i < SCENE_LIGHTS; ++i) direct += litBy(i, s, gloss_open);
#if AO_ON == AO_ON_EVERYTHING
    direct *= open;
#endif
    light += direct;
#endif
    return light;
}
