#version 300 es
// SPDX-License-Identifier: MIT
// Which pixels an estimator has to look at.
//
//   surface  interface: point in view space
//   depth    0 in the background, 1 elsewhere
precision highp float;  // as the surface has it

#define SURFACE_WITHOUT_NORMAL
#include <surface>

in vec2 uv;

void main()
{
    vec3 point;
    gl_FragDepth = viewPosition(uv, point) ? 1.0 : 0.0;
}
