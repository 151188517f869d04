#version 300 es
// SPDX-License-Identifier: MIT
// Puts the pixels of 4x4 tiles back where they were.
//
//   stored_depth  has the view's size
//   ao_tiles      in tiles of every fourth pixel
//   ao            the same, pixel by pixel
precision highp float;
precision highp int;

#include "ssao/shaders/tiles.glsl"

uniform mediump sampler2D ao_tiles;

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    ivec2 pixel = ivec2(uv * vec2(viewPixels()));
    ao = texelFetch(ao_tiles, texelOfPixel(pixel, textureSize(ao_tiles, 0) / 4), 0).r;
}
