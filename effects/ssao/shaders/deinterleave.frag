#version 300 es
// SPDX-License-Identifier: MIT
// Sorts the view's pixels into sixteen tiles: each has every fourth pixel of every fourth row, so that taps
// that lie apart in the view lie close together in a tile.
//
//   surface       interface: normal in view space
//   stored_depth  window depth
//   depth_tiles   the same in 4x4 tiles, in the order of the pixels that each begins with
//   normal_tiles  view space, stored as n * 0.5 + 0.5
//
// [Bavoil, Jansen 2013, "Particle Shadows & Cache-Efficient Post-Processing"]
precision highp float;
precision highp int;

#include <surface>
#include "ssao/shaders/tiles.glsl"

uniform vec2 viewport_size;

layout(location = 0) out vec4 normal_tiles;

void main()
{
    vec2 at = uvOfPixel(pixelOfTexel(ivec2(gl_FragCoord.xy), ivec2(viewport_size) / 4));
    ivec2 texel = texelInGuardBand(at, vec2(textureSize(stored_depth, 0)));
    gl_FragDepth = texelFetch(stored_depth, texel, 0).r;
    normal_tiles = vec4(normalAt(at) * 0.5 + 0.5, 1.0);
}
