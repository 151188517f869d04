#version 300 es
// SPDX-License-Identifier: MIT
// A G-buffer without positions and normals: both are rebuilt from depth.
//
//   albedo          linear colour; alpha is the strength of the highlight
//   ambient_factor  with SCENE_MATERIAL_AMBIENT: the material's share of the ambient light
precision highp float;

#include "geometry/shaders/material.glsl"

in vec2 uv;

layout(location = 0) out vec4 albedo;
#if SCENE_MATERIAL_AMBIENT
layout(location = 1) out float ambient_factor;
#endif

void main()
{
    albedo = materialAlbedo(uv);
#if SCENE_MATERIAL_AMBIENT
    ambient_factor = material_ambient;
#endif
}
