#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

uniform sampler2D depth;
#include "./ring.glsl"

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    ao = texture(depth, uv).r * 1.0;
}
