#version 300 es
// SPDX-License-Identifier: MIT
// Deferred lighting: ambient, diffuse and a Blinn-Phong highlight from points and directional lights.
//
//   surface     interface: point and normal in view space
//   albedo      linear colour; alpha is the strength of the highlight
//   visibility  1 open .. 0 blocked
//   color       sRGB, ready to show
//   AO_ON       whether the visibility dims the ambient light or everything
//   DISPLAY     the lit picture with occlusion, without, or the occlusion alone
//
// [Blinn 1977, "Models of Light Reflection for Computer Synthesized Pictures"]
precision highp float;  // positions

#if DISPLAY != DISPLAY_NO_AO
uniform mediump sampler2D visibility;
#endif
#if DISPLAY != DISPLAY_AO_ONLY
#if SCENE_LIGHTS == 0
#define SURFACE_WITHOUT_NORMAL
#endif
#include "lighting/srgb.glsl"
#include <surface>

uniform mediump sampler2D albedo;
uniform vec3 ambient_light;
uniform float ambient;
uniform vec3 background_color;
#if SCENE_LIGHTS > 0
uniform vec4 light_position[MAX_LIGHTS];
uniform vec3 light_color[MAX_LIGHTS];
uniform vec3 light_attenuation[MAX_LIGHTS];
#if SCENE_SPECULAR
uniform float specular_power;
#endif
#endif
#endif

in vec2 uv;
layout(location = 0) out vec4 color;

#if DISPLAY != DISPLAY_AO_ONLY && SCENE_LIGHTS > 0
vec3 litBy(int i, vec3 point, vec3 normal, vec4 surface_albedo)
{
    vec3 to_light = light_position[i].xyz - point * light_position[i].w;
    float distance = length(to_light);
    vec3 direction = to_light / max(distance, 1e-20);
    // A directional light does not fade.
    float reach = distance * light_position[i].w;
    vec3 a = light_attenuation[i];
    float fade = 1.0 / max(a.x + reach * (a.y + reach * a.z), 1e-6);
    vec3 reflected = surface_albedo.rgb * max(dot(normal, direction), 0.0);
#if SCENE_SPECULAR
#if CAMERA_ORTHOGRAPHIC
    vec3 to_eye = vec3(0.0, 0.0, 1.0);
#else
    vec3 to_eye = -normalize(point);
#endif
    vec3 halfway = direction + to_eye;
    float facing = max(dot(normal, halfway / max(length(halfway), 1e-20)), 0.0);
    if (facing > 0.0) reflected += surface_albedo.a * pow(facing, specular_power);
#endif
    return light_color[i] * reflected * fade;
}
#endif

void main()
{
#if DISPLAY == DISPLAY_AO_ONLY
    color = vec4(vec3(texture(visibility, uv).r), 1.0);
#else
    vec3 point;
    if (!pointAt(uv, point)) {
        color = vec4(srgbFromLinear(background_color), 1.0);
        return;
    }
    vec4 surface_albedo = texture(albedo, uv);
#if DISPLAY == DISPLAY_NO_AO
    float open = 1.0;
#else
    float open = texture(visibility, uv).r;
#endif
    vec3 light = surface_albedo.rgb * ambient_light * ambient * open;
#if SCENE_LIGHTS > 0
    vec3 normal_here = normalAt(uv);
    vec3 direct = vec3(0.0);
    for (int i = 0; i < SCENE_LIGHTS; ++i) direct += litBy(i, point, normal_here, surface_albedo);
#if AO_ON == AO_ON_EVERYTHING
    direct *= open;
#endif
    light += direct;
#endif
    color = vec4(srgbFromLinear(light), 1.0);
#endif
}
