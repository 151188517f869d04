#version 300 es
// SPDX-License-Identifier: MIT
// The error to expect at each pixel.
//
//   doubt_tiles  x: share of the root of the darkness that the error is expected to be, in tiles of 4x4 texels of `ao`
//   ao           unfiltered occlusion, for its size
//   ao_filtered  occlusion
//   doubt        the error, 0 in the background
precision highp float;

uniform mediump sampler2D doubt_tiles;
uniform mediump sampler2D ao;
uniform mediump sampler2D ao_filtered;

in vec2 uv;
layout(location = 0) out float doubt;

void main()
{
    float dark = 1.0 - texelFetch(ao_filtered, ivec2(gl_FragCoord.xy), 0).r;
    vec2 tiles = 0.25 * vec2(textureSize(ao, 0)) / vec2(textureSize(doubt_tiles, 0));
    doubt = texture(doubt_tiles, uv * tiles).r * sqrt(max(dark, 0.0));
}
