// SPDX-License-Identifier: MIT
// Interface `reflection`, glTF's metallic-roughness, for forward shaders: light and surroundings, mirrored by a rough
// surface and scattered below it; and light of the surface's own.
//
//   reflections  what is seen of the surroundings (lighting/shaders/reflections.frag)
//   uv           the material's
//
// [Walter et al. 2007 - GGX; Heitz 2014 - shadowing, with heights correlated; Schlick 1994 - Fresnel;
//  Karis 2014 - the share of surroundings that is mirrored; Turquin 2019 - and by more than one facet]

#include "lighting/shaders/sphere_map.glsl"
#include "lighting/shaders/caps.glsl"

#define HIGHLIGHTS 1

uniform mediump sampler2D reflections;
uniform highp mat4 world_from_view;
uniform float metallic;
uniform float roughness;
uniform float reflectance;
uniform float unlit;
uniform vec3 emission;
#if SCENE_METAL_MAPPED
uniform mediump sampler2D metallic_roughness_map;
#endif
#if SCENE_EMISSION_MAPPED
uniform mediump sampler2D emission_map;
#endif

struct Reflecting {
    vec3 diffuse;       // albedo of what scatters
    vec3 ahead;         // mirrored of light from ahead
    highp float rough;  // perceived: the square root of GGX's alpha
    highp vec3 to_eye;
    highp float facing;  // cosine between normal and eye
};

Reflecting reflectingOf(Surface s)
{
    vec2 of = vec2(clamp(roughness, 0.0, 1.0), clamp(metallic, 0.0, 1.0));
#if SCENE_METAL_MAPPED
    of *= texture(metallic_roughness_map, uv).gb;
#endif
    Reflecting r;
    r.diffuse = s.albedo * (1.0 - of.y);
    r.ahead = mix(vec3(reflectance), s.albedo, of.y);
    r.rough = max(of.x, 0.06);  // sharper highlights fall between pixels
    r.to_eye = toEye(s.point);
    r.facing = clamp(abs(dot(s.normal, r.to_eye)), 1e-3, 1.0);
    return r;
}

// What a light of that direction gives. As elsewhere, of a light of 1 a white surface that faces it shows 1.
vec3 reflectedFrom(Reflecting r, Surface s, float gloss_open, highp vec3 direction)
{
    highp float lit = dot(s.normal, direction);
    if (lit <= 0.0) return vec3(0.0);
    highp vec3 halfway = direction + r.to_eye;
    halfway /= max(length(halfway), 1e-6);
    highp float alpha2 = r.rough * r.rough * r.rough * r.rough;
    highp float upright = clamp(dot(s.normal, halfway), 0.0, 1.0);
    highp float shape = upright * upright * (alpha2 - 1.0) + 1.0;
    highp float shadowed = lit * sqrt(r.facing * r.facing * (1.0 - alpha2) + alpha2) +
                           r.facing * sqrt(lit * lit * (1.0 - alpha2) + alpha2);
    highp float lobe = 0.5 * alpha2 / (shape * shape * max(shadowed, 1e-6));
    highp float grazing = 1.0 - clamp(dot(r.to_eye, halfway), 0.0, 1.0);
    vec3 mirrored = r.ahead + (1.0 - r.ahead) * (grazing * grazing * grazing * grazing * grazing);
    return lit * (r.diffuse * (1.0 - mirrored) + gloss_open * mirrored * lobe);
}

// One of the maps of `reflections`.
vec3 mapped(highp vec2 place, highp float level)
{
    highp float margin = 0.5 / 32.0;  // half a texel of a map, so that none bleeds into the next
    return texture(reflections, vec2(place.x, (level + clamp(place.y, margin, 1.0 - margin)) / kMaps)).rgb;
}

// Seen in the mirrored direction: the shares of `ahead`, and beside it, that surroundings give on average.
vec2 mirroredShare(highp float rough, highp float facing)
{
    highp vec4 r = rough * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    highp float a = min(r.x * r.x, exp2(-9.28 * facing)) * r.x + r.y;
    return vec2(-1.04, 1.04) * a + r.zw;
}

// Where the material has baked occlusion, the lesser of both: a product would darken twice what both know of.
vec3 reflectedAround(Reflecting r, Surface s, float screen_open)
{
    float open = min(screen_open, materialOpen(uv));
    highp mat3 turn = mat3(world_from_view);
    vec2 share = mirroredShare(r.rough, r.facing);
    vec3 mirrored = (r.ahead * share.x + share.y) * (1.0 + r.ahead * (1.0 / (share.x + share.y) - 1.0));
    vec3 scattered = mapped(placeOf(turn * s.normal), kMaps - 1.0) * r.diffuse * ambientOpen(open, r.diffuse);
    highp vec2 place = placeOf(turn * reflect(-r.to_eye, s.normal));
    highp float level = r.rough * 3.0;
    highp float sharper = min(floor(level), 2.0);
    vec3 seen = mix(mapped(place, sharper), mapped(place, sharper + 1.0), level - sharper);
    highp float alpha = r.rough * r.rough;
    float seen_open = glossOpen(open, r.facing, 2.0 / (alpha * alpha) - 2.0);
    return ambient_light * ambient * mix(scattered, seen * seen_open, mirrored);
}

// What reaches the eye, of a surface that sends it that much of others' light.
vec3 withOwnLight(Surface s, vec3 light)
{
    vec3 own = emission;
#if SCENE_EMISSION_MAPPED
    own *= texture(emission_map, uv).rgb;
#endif
    return mix(light, s.albedo, unlit) + own;
}
