#version 300 es
// SPDX-License-Identifier: MIT
// A G-buffer with stored positions.
//
//   position  view space, scene units; alpha 1 on a surface, 0 (the clear value) in the background
//   normal    view space, stored as n * 0.5 + 0.5; alpha likewise
//   albedo    linear colour; alpha is the strength of the highlight
//   ambient_factor  with SCENE_MATERIAL_AMBIENT: the material's share of the ambient light
precision highp float;

#include "geometry/shaders/material.glsl"

in vec3 point;
in vec3 facing;
in vec2 uv;

layout(location = 0) out vec4 position;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 albedo;
#if SCENE_MATERIAL_AMBIENT
layout(location = 3) out float ambient_factor;
#endif

void main()
{
    albedo = materialAlbedo(uv);
    position = vec4(point, 1.0);
    normal = vec4(materialNormal(point, planeOf(point), facing, uv) * 0.5 + 0.5, 1.0);
#if SCENE_MATERIAL_AMBIENT
    ambient_factor = material_ambient;
#endif
}
