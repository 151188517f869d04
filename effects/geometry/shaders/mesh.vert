#version 300 es
// SPDX-License-Identifier: MIT
// A triangle mesh in view space, for every geometry pass.
//
//   point   view space, scene units
//   facing  vertex normal in view space, not normalised
//   uv      texture coordinates of the material
precision highp float;

#include "common/guard_band.glsl"

uniform mat4 clip_from_model;
uniform mat4 view_from_model;
uniform mat3 view_normal_from_model;
uniform vec2 viewport_size;  // with the guard band

layout(location = 0) in vec3 model_point;
layout(location = 1) in vec3 model_normal;
layout(location = 2) in vec2 model_uv;

invariant gl_Position;  // a sheet's back is its front, in any pass

out vec3 point;
out vec3 facing;
out vec2 uv;

void main()
{
    point = (view_from_model * vec4(model_point, 1.0)).xyz;
    facing = view_normal_from_model * model_normal;
    uv = model_uv;
    gl_Position = clip_from_model * vec4(model_point, 1.0);
    gl_Position.xy *= viewShareOf(viewport_size);
}
