#version 300 es
// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   ao                           visibility, 1 open .. 0 blocked; 1 in the background
//
// [Bavoil, Sainz 2008]
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include "ssao/shaders/hbao.glsl"

layout(location = 0) out float ao;

void main()
{
    ao = visibilityAt(gl_FragCoord.xy);
}
