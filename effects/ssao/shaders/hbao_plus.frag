#version 300 es
// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion within 4x4 tiles of every fourth pixel: all of a tile marches along the same
// directions and reads only its own texels, as if it were a picture of a quarter of the size.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them, in tiles and without the guard band
//   ao_tiles                     visibility in the same tiles, 1 open .. 0 blocked; 1 in the background
//
// [Bavoil, Sainz 2008; Bavoil, Jansen 2013]
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include "ssao/shaders/tiles.glsl"

// The tile of this pixel, its first texel and its size.
ivec2 tile;
ivec2 tile_corner;
vec2 tile_size;

#define MARCH_IN_TILES
vec2 stride() { return vec2(4.0); }
vec2 inView(vec2 pixel) { return 4.0 * pixel + (vec2(tile) - 1.5); }
vec2 marchedSize() { return tile_size; }
ivec2 marchedTexel(vec2 pixel) { return ivec2(pixel) + tile_corner; }

#include <estimator>

layout(location = 0) out float ao_tiles;

void main()
{
    ivec2 size = ivec2(viewport_size);
    tile = tileOf(ivec2(gl_FragCoord.xy), size);
    tile_corner = cornerOf(tile, size);
    tile_size = vec2((size + 3 - tile) / 4);
    March march;
    bool known = marchFrom(gl_FragCoord.xy - vec2(tile_corner), march);
    ao_tiles = visibilityFrom(march, known);
}
