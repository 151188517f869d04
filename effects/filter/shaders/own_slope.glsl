// SPDX-License-Identifier: MIT
// The slope of a pixel's own surface. Needs the interface `surface` before it.
//
//   DEPTH_CUT_FROM  slope: as said, so that a floor seen at a grazing angle is filtered as well as a wall, which is
//                   ours; depth: none, so that depths themselves are compared, as authors do

// How much view depth changes by `step` in uv: on the side where it is less, which at an edge is the pixel's own.
highp float ownSlope(highp vec2 at, highp float center_z, highp vec2 step)
{
#if DEPTH_CUT_FROM == DEPTH_CUT_FROM_DEPTH
    return 0.0;
#else
    highp float before = center_z - viewZAt(at - step);
    highp float after = viewZAt(at + step) - center_z;
    return abs(before) < abs(after) ? before : after;
#endif
}
