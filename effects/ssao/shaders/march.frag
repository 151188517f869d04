#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion by an estimator that marches over the screen.
//
//   estimator                    interface: what is blocked about a point
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   ao                           visibility, 1 open .. 0 blocked; 1 in the background
precision highp float;  // positions and depths; mediump bands
precision highp int;    // all 32 bits of a mask: mediump has 16

#include <estimator>

layout(location = 0) out float ao;

void main()
{
    March march;
    bool known = marchFrom(gl_FragCoord.xy, march);
    ao = visibilityFrom(march, known);
}
