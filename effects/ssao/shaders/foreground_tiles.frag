#version 300 es
// SPDX-License-Identifier: MIT
// Which texels of 4x4 tiles an estimator has to look at.
//
//   depth_tiles  window depth in the same tiles
//   depth        1 where something was drawn; 0 in the background
precision highp float;

#include "common/view_space.glsl"

uniform highp sampler2D depth_tiles;

void main()
{
    gl_FragDepth = isDrawn(texelFetch(depth_tiles, ivec2(gl_FragCoord.xy), 0).r) ? 1.0 : 0.0;
}
