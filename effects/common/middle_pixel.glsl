// SPDX-License-Identifier: MIT
// Where a picture of a third of the view's size sees the view, or of a fifth or another odd share: at the middle of one
// of its pixels, each. So what is drawn at that size and what is read of the full one are of one place: of a thin thing
// the front that one has belongs to the back that the other has. Ours.
//
// A third of 1280 pixels is 427, 2.998 pixels wide each. They are taken to be 3 wide, about the middle of the view: so
// they see it at most a pixel from where they lie. Of other shares no such pixel is always near: they see where they lie.

#include "common/host_picture.glsl"

uniform highp vec2 view_size;

// The view in its pixels, as a picture of it of `size` sees it.
highp vec2 seenSize(highp vec2 size)
{
    highp vec2 odd = (2.0 * floor(0.5 * view_size / size) + 1.0) * size;
    return mix(view_size, odd, lessThanEqual(abs(odd - view_size), vec2(2.0)));
}

// From the middle of the view to that of what is seen, in its pixels: half of one, or none.
highp vec2 seenShift(highp vec2 size)
{
    return fract(0.5 * abs(view_size - seenSize(size))) * pictureFromHost(vec2(1.0));
}

// The view's uv that a picture of it of `size` sees at `uv`.
highp vec2 seenUv(highp vec2 uv, highp vec2 size)
{
    return 0.5 + ((uv - 0.5) * seenSize(size) + seenShift(size)) / view_size;
}

// The place in clip space, x y and w, at which it sees what the view has at `clip`.
highp vec2 clipWhereSeen(highp vec3 clip, highp vec2 size)
{
    return (clip.xy * view_size - 2.0 * seenShift(size) * clip.z) / seenSize(size);
}
