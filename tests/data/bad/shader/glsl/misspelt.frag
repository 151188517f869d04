#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

uniform sampler2D depth;
uniform float raduis;

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    ao = texture(depth, uv).r * raduis;
}
