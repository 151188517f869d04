#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

layout(location = 0) out float ao;

void main()
{
    ao = 1.0;
}
