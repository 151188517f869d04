// SPDX-License-Identifier: MIT
// Interface `reflection`: matte surfaces, with highlights of one strength in all colours.
//
//   REFLECTION  lambert has no highlights; phong measures them at the mirrored light, blinn_phong
//               halfway between light and eye
//
// [Lambert 1760; Phong 1975; Blinn 1977]

#if SCENE_LIGHTS > 0 && SCENE_SPECULAR && REFLECTION != REFLECTION_LAMBERT
#define HIGHLIGHTS 1
uniform float specular_power;
#else
#define HIGHLIGHTS 0
#endif

struct Reflecting {
    vec3 diffuse;
};

Reflecting reflectingOf(Surface s)
{
    return Reflecting(s.albedo);
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

// What a light of that direction gives; `gloss_open` dims the highlights alone.
vec3 reflectedFrom(Reflecting r, Surface s, float gloss_open, highp vec3 direction)
{
    vec3 reflected = r.diffuse * max(dot(s.normal, direction), 0.0);
#if HIGHLIGHTS
    reflected += s.gloss * gloss_open * highlight(s.normal, direction, toEye(s.point));
#endif
    return reflected;
}

// What the ambient light gives.
vec3 reflectedAround(Reflecting r, Surface s, float open)
{
    return r.diffuse * ambient_light * ambient * ambientOpen(open, r.diffuse);
}

vec3 withOwnLight(Surface s, vec3 light)
{
    return light;
}
