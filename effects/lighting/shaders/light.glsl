// SPDX-License-Identifier: MIT
// The scene's lights: points, spots and directional ones.

uniform vec4 light_position[MAX_LIGHTS];
uniform vec3 light_color[MAX_LIGHTS];
uniform vec3 light_attenuation[MAX_LIGHTS];
uniform vec4 light_cone[MAX_LIGHTS];

// The light that arrives at a point in view space, and the unit vector to where it comes from.
vec3 lightFrom(int i, highp vec3 point, out highp vec3 direction)
{
    highp vec3 to_light = light_position[i].xyz - point * light_position[i].w;
    highp float distance = length(to_light);
    direction = to_light / max(distance, 1e-20);
    highp float reach = distance * light_position[i].w;  // a directional light does not fade
    highp float cone = clamp(dot(light_cone[i].xyz, direction) + light_cone[i].w, 0.0, 1.0);
    highp vec3 a = light_attenuation[i];
    return light_color[i] * (cone * cone) / max(a.x + reach * (a.y + reach * a.z), 1e-6);
}
