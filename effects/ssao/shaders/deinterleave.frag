#version 300 es
// SPDX-License-Identifier: MIT
// Sorts the view's pixels into sixteen tiles: each has every fourth pixel of every fourth row, so that taps
// that lie apart in the view lie close together in a tile.
//
//   source_depth, source_normal  as ssao/shaders/source.frag writes them
//   depth_tiles, normal_tiles    the same without the guard band, in 4x4 tiles, in the order of the pixels that each
//                                begins with
//
// [Bavoil, Jansen 2013]
precision highp float;  // depths
precision highp int;

#include "ssao/shaders/tiles.glsl"

uniform highp sampler2D source_depth;
uniform mediump sampler2D source_normal;
uniform vec2 viewport_size;

layout(location = 0) out vec4 normal_tiles;

void main()
{
    ivec2 size = ivec2(viewport_size);
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 tile = tileOf(texel, size);
    ivec2 band = (textureSize(source_depth, 0) - size) / 2;
    ivec2 pixel = 4 * (texel - cornerOf(tile, size)) + tile + band;
    gl_FragDepth = texelFetch(source_depth, pixel, 0).r;
    normal_tiles = texelFetch(source_normal, pixel, 0);
}
