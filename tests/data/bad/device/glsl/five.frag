#version 300 es
// SPDX-License-Identifier: MIT
precision highp float;

layout(location = 0) out float a;
layout(location = 1) out float b;
layout(location = 2) out float c;
layout(location = 3) out float d;
layout(location = 4) out float e;

void main()
{
    a = b = c = d = e = 1.0;
}
