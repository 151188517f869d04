#version 300 es
// SPDX-License-Identifier: MIT
// Puts the pixels of 4x4 tiles back where they were.
//
//   ao_tiles  in tiles of every fourth pixel
//   ao        the same, pixel by pixel
precision highp float;
precision highp int;

#include "ssao/shaders/tiles.glsl"

uniform mediump sampler2D ao_tiles;

layout(location = 0) out float ao;

void main()
{
    ao = texelFetch(ao_tiles, texelOfPixel(ivec2(gl_FragCoord.xy), textureSize(ao_tiles, 0)), 0).r;
}
