#version 300 es
// SPDX-License-Identifier: MIT
// A G-buffer without positions: depth is kept and the position rebuilt from it.
//
//   normal        view space, stored as n * 0.5 + 0.5; alpha 1 on a surface, 0 (the clear value) elsewhere
//   albedo        linear colour; alpha is the strength of the highlight
//   plane         without LINEAR_DEPTH: normal of the triangle, stored as `normal`
//   baked_ao      with BAKED_AO: the material's own visibility, 1 open
//   linear_depth  with LINEAR_DEPTH: distance along the view axis; 0 (the clear value) in the background
//   ambient_factor  with SCENE_MATERIAL_AMBIENT, without BAKED_AO: the material's share of the ambient light
precision highp float;

#include "geometry/shaders/material.glsl"

in vec3 point;
in vec3 facing;
in vec2 uv;

layout(location = 0) out vec4 normal;
layout(location = 1) out vec4 albedo;
#ifdef LINEAR_DEPTH
layout(location = 2) out highp float linear_depth;
#else
layout(location = 2) out vec4 plane;
#endif
#ifdef BAKED_AO
layout(location = 3) out float baked_ao;
#elif SCENE_MATERIAL_AMBIENT
layout(location = 3) out float ambient_factor;
#endif

void main()
{
    albedo = materialAlbedo(uv);
    vec3 triangle = planeOf(point);
    normal = vec4(materialNormal(point, triangle, facing, uv) * 0.5 + 0.5, 1.0);
#ifdef LINEAR_DEPTH
    linear_depth = -point.z;
#else
    plane = vec4(triangle * 0.5 + 0.5, 1.0);
#endif
#ifdef BAKED_AO
    baked_ao = materialOpen(uv);
#elif SCENE_MATERIAL_AMBIENT
    ambient_factor = material_ambient;
#endif
}
