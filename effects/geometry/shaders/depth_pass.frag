#version 300 es
// SPDX-License-Identifier: MIT
// Depth alone; what the alpha test cuts away is discarded.
precision highp float;

#include "geometry/shaders/material.glsl"

in vec2 uv;

void main()
{
    materialAlbedo(uv);
}
