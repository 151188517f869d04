// SPDX-License-Identifier: MIT
// Two numbers in 0..1 a pixel, to turn a pattern of samples and to shift it along itself.
//
//   ROTATION_TILE      sixteen pairs that stand well apart, in a tile of 4x4 pixels: whatever averages
//                      four by four pixels sees all of them once
//   ROTATION_GRADIENT  each 3x3 pixels see numbers well apart, and no tile repeats: for a mean over frames
//   ROTATION_NONE      the same for all pixels: bands, but nothing to filter
//
// With MOVING_NOISE both move on by golden ratios from frame to frame, for a mean over frames, in cycles of kNoiseCycle.
//
// [Jimenez 2014 - the gradient, its constants]
// [Roberts 2018 - R1, steps of 0.61803399, the golden ratio less 1; and R2, steps of 0.75487767 and 0.56984029, which
//  are 1 / g and 1 / g^2 for g^3 = g + 1]
// [Bayer 1973 - the tile]

highp vec2 stillNoise(highp vec2 pixel)
{
#if ROTATION == ROTATION_GRADIENT
    highp float turn = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return vec2(turn, fract(dot(pixel, vec2(0.75487767, 0.56984029))));
#elif ROTATION == ROTATION_TILE
    highp ivec2 at = ivec2(mod(pixel, 4.0));
    // A Bayer matrix of the turns, so that neighbours differ by much.
    highp int across = at.x ^ at.y;
    highp int order = (across & 1) * 8 + (at.y & 1) * 4 + (across >> 1) * 2 + (at.y >> 1);
    // The shift steps by the golden ratio from pixel to pixel, number x + 4 y, and by 1/4 more from row to row: ours.
    return vec2((float(order) + 0.5) / 16.0, fract(dot(vec2(at), vec2(0.61803399, 2.72213596))));
#else
    return vec2(0.5);
#endif
}

#ifndef MOVING_NOISE
#define MOVING_NOISE 0
#endif

#if MOVING_NOISE
#include "common/noise_cycle.glsl"

uniform highp int frame_index;

highp vec2 pixelNoise(highp vec2 pixel)
{
    return fract(stillNoise(pixel) + float(frame_index % kNoiseCycle) * vec2(0.61803399, 0.75487767));
}
#else
highp vec2 pixelNoise(highp vec2 pixel) { return stillNoise(pixel); }
#endif
