#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

uniform sampler2D depth;

in vec2 uv;

void main()
{
}
