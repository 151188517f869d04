#version 310 es
// SPDX-License-Identifier: MIT
// One triangle that covers the viewport, for fragment shaders that need OpenGL ES 3.1: both stages of a
// program are of one version.

void main()
{
    vec2 uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
