#version 300 es
// SPDX-License-Identifier: MIT
// A triangle mesh in view space, for every geometry pass.
//
//   point   view space, scene units
//   facing  vertex normal in view space, not normalised
//   uv      texture coordinates of the material
precision highp float;

#include "common/guard_band.glsl"
#include "common/middle_pixel.glsl"
#include <vertex>

uniform mat4 clip_from_model;
uniform mat4 view_from_model;
uniform mat3 view_normal_from_model;
uniform vec2 viewport_size;  // with the guard band

invariant gl_Position;  // a sheet's back is its front, in any pass

out vec3 point;
out vec3 facing;
out vec2 uv;

void main()
{
    vec4 at = vec4(modelPoint(), 1.0);
    point = (view_from_model * at).xyz;
    facing = view_normal_from_model * modelNormal();
    uv = modelUv();
    gl_Position = clip_from_model * at;
#ifdef SMALL_PICTURE
    gl_Position.xy = clipWhereSeen(gl_Position.xyw, viewSizeIn(viewport_size));
#endif
    gl_Position.xy *= viewShareOf(viewport_size);
}
