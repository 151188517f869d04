#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

uniform sampler2D depth;
uniform mat4 clip_from_model;

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    ao = texture(depth, uv).r * clip_from_model[0][0];
}
