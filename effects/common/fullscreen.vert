#version 300 es
// SPDX-License-Identifier: MIT
// One triangle that covers the viewport; needs no vertex buffer.
//
//   uv   0..1 over the viewport, from the lower left

out highp vec2 uv;

void main()
{
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
