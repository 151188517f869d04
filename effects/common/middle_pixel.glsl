// SPDX-License-Identifier: MIT
// Where a picture of a half, a third or another whole share of the view's size sees the view, if layers of depth are drawn
// at that size (geometry/back_faces): at the middle of one of its pixels, each. So what is drawn at that size and what is
// read of the full one are of one place: of a thin thing the front that one has belongs to the back that the other has. Ours.
//
// A third of 1280 pixels is 427, 2.998 pixels wide each. They are taken to be 3 wide, about the middle of the view: so
// they see it at most a pixel from where they lie; of a half half a pixel. Of other shares no pixel is always near: they
// see where they lie.

#include "common/host_picture.glsl"

#ifndef BACK_FACES
#define BACK_FACES 0
#endif

uniform highp vec2 view_size;

// How many pixels of the view one of a picture of it of `size` sees, across: a whole number, or as many as it covers.
highp vec2 seenPixels(highp vec2 size)
{
    highp vec2 covered = view_size / size;
    highp vec2 whole = floor(covered + 0.5);
    bvec2 near = lessThan(abs(whole * size - view_size), whole);
    return mix(covered, whole, near);
}

// From the middle of the view to that of what is seen, in its pixels: half of one, or none.
highp vec2 seenShift(highp vec2 size)
{
    highp vec2 pixels = seenPixels(size);
    bvec2 whole = equal(pixels, floor(pixels));
    highp vec2 halves = fract(0.5 * abs(pixels * (size + 1.0) - 1.0 - view_size));
    return mix(vec2(0.0), halves, whole) * pictureFromHost(vec2(1.0));
}

// The view's uv that a picture of it of `size` sees at `uv`.
highp vec2 seenUv(highp vec2 uv, highp vec2 size)
{
#if BACK_FACES
    uv = 0.5 + ((uv - 0.5) * seenPixels(size) * size + seenShift(size)) / view_size;
#endif
    return uv;
}

// The place in clip space, x y and w, at which it sees what the view has at `clip`.
highp vec2 clipWhereSeen(highp vec3 clip, highp vec2 size)
{
    return (clip.xy * view_size - 2.0 * seenShift(size) * clip.z) / (seenPixels(size) * size);
}
