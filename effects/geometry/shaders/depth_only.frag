#version 300 es
// SPDX-License-Identifier: MIT
// A G-buffer without positions and normals: both are rebuilt from depth.
//
//   albedo  linear colour; alpha is the strength of the highlight
precision highp float;

#include "geometry/shaders/material.glsl"

in vec2 uv;

layout(location = 0) out vec4 albedo;

void main()
{
    albedo = materialAlbedo(uv);
}
