#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a mean over four pixels of light that stops at edges, as filter/bilateral_normal's of occlusion.
//
//   source_depth       depth as a share, with the guard band
//   source_normal      normals, with the guard band
//   indirect           linear colour
//   indirect_filtered  the weighted mean
//   AXIS               vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// [Tomasi, Manduchi 1998]
precision highp float;  // depths are compared
precision highp int;

#include "common/host_picture.glsl"
#include "filter/shaders/off_plane.glsl"

uniform mediump sampler2D indirect;
uniform highp sampler2D source_depth;

layout(location = 0) out vec4 indirect_filtered;

// Off the view the nearest pixel.
ivec2 pixelAt(ivec2 pixel) { return clamp(pixel, ivec2(0), textureSize(indirect, 0) - 1); }

void main()
{
    ivec2 band = (textureSize(source_depth, 0) - textureSize(indirect, 0)) / 2;
    ivec2 axis = ivec2(pictureFromHost(AXIS));
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 first = pixelAt(pixel - 2 * axis);
    ivec2 before = pixelAt(pixel - axis);
    ivec2 after = pixelAt(pixel + axis);
    ivec2 last = pixelAt(pixel + 2 * axis);
    vec4 shares = vec4(texelFetch(source_depth, first + band, 0).r, texelFetch(source_depth, before + band, 0).r,
                       texelFetch(source_depth, after + band, 0).r, texelFetch(source_depth, last + band, 0).r);
    float share = texelFetch(source_depth, pixel + band, 0).r;
    vec4 weights = weightsAlong(vec2(axis), share, shares, texelFetch(source_normal, pixel + band, 0));
    vec3 sum = texelFetch(indirect, pixel, 0).rgb;
    sum += weights.x * texelFetch(indirect, first, 0).rgb + weights.y * texelFetch(indirect, before, 0).rgb;
    sum += weights.z * texelFetch(indirect, after, 0).rgb + weights.w * texelFetch(indirect, last, 0).rgb;
    indirect_filtered = vec4(sum / (1.0 + dot(weights, vec4(1.0))), 1.0);
}
