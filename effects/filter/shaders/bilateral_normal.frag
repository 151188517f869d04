#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a separable mean over four pixels that stops at steps and edges in depth.
//
//   ao             what is filtered; with PACKED its depth beside it: r, and the digits of its share in gba
//   source_depth   without PACKED: depth as a share, with the guard band
//   source_normal  normals, with the guard band
//   ao_filtered    the weighted mean; unchanged in the background and where no neighbour counts. With PACKS its depth
//                  beside it; with MARKS_FLAT marked where the square to the right and above is one plane
//   AXIS           vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// Five taps, the outer ones by half: on a plane each of four neighbouring columns counts alike, so that noise which
// repeats every four pixels vanishes, and the picture does not shift. Beside a crease or an edge, where neighbours lie on
// one side alone, the mean follows their slope back to the pixel. The taps and that are ours, as is all of off_plane.glsl
// but the idea, weights by what is seen: docs/reference/filters.md has its error and cost. [Tomasi, Manduchi 1998]
precision highp float;  // depths are compared
precision highp int;

#include "common/host_picture.glsl"
#include "filter/shaders/off_plane.glsl"

uniform mediump sampler2D ao;
#if !PACKED
uniform highp sampler2D source_depth;
#endif

#if PACKS
layout(location = 0) out vec4 ao_filtered;
#else
layout(location = 0) out float ao_filtered;
#endif

// The steepest that occlusion is beside a wall, per radius: 2 / pi, the slope of 1 - (acos d - d sqrt(1 - d d)) / pi at 0.
const float kSteepest = 0.64;

// Of places, in square pixels: the smaller, the more noise is taken for a slope. With 0.1 mean errors are 0.0003 smaller,
// and creases have beads.
const float kUnevenness = 0.25;

// Occlusion and share of a pixel; off the view those of the nearest one.
vec2 valueAt(ivec2 pixel, ivec2 band)
{
    ivec2 inside = clamp(pixel, ivec2(0), textureSize(ao, 0) - 1);
#if PACKED
    vec4 stored = texelFetch(ao, inside, 0);
    return vec2(stored.r, shareOfDigits(stored.gba));
#else
    return vec2(texelFetch(ao, inside, 0).r, texelFetch(source_depth, inside + band, 0).r);
#endif
}

void main()
{
    ivec2 band = (textureSize(source_normal, 0) - textureSize(ao, 0)) / 2;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 axis = ivec2(pictureFromHost(AXIS));
    vec2 here = valueAt(pixel, band);
    vec2 before = valueAt(pixel - axis, band);
    vec2 after = valueAt(pixel + axis, band);
    vec2 first = valueAt(pixel - 2 * axis, band);
    vec2 last = valueAt(pixel + 2 * axis, band);
    vec4 shares = vec4(first.y, before.y, after.y, last.y);
    vec4 values = vec4(first.x, before.x, after.x, last.x);
    mediump vec4 own = texelFetch(source_normal, pixel + band, 0);
    vec4 weights = weightsAlong(vec2(axis), here.y, shares, own);
    float all = 1.0 / (1.0 + dot(weights, vec4(1.0)));
    float mean = (here.x + dot(weights, values)) * all;
    // The line through the values, by least squares.
    const vec4 kPlaces = vec4(-2.0, -1.0, 1.0, 2.0);
    vec4 placed = weights * kPlaces * all;
    float middle = dot(placed, vec4(1.0));
    float slope = (dot(placed, values) - middle * mean) / (dot(placed, kPlaces) - middle * middle + kUnevenness);
    float steepest = kSteepest * wayAlong(vec2(axis), here.y, own) / max(radius, 1e-20);
    mean = clamp(mean - middle * clamp(slope, -steepest, steepest), 0.0, 1.0);
#ifdef MARKS_FLAT
    vec2 right = pictureFromHost(vec2(1.0, 0.0));
    vec2 above = pictureFromHost(vec2(0.0, 1.0));
    vec3 square = vec3(valueAt(pixel + ivec2(right), band).y, valueAt(pixel + ivec2(above), band).y,
                       valueAt(pixel + ivec2(right + above), band).y);
    ao_filtered = vec4(mean, markedDigits(here.y, isFlat(right, above, here.y, square, own)));
#elif PACKS
    ao_filtered = vec4(mean, digitsOfShare(here.y));
#else
    ao_filtered = mean;
#endif
}
