// SPDX-License-Identifier: MIT
// The guard band: whole pixels around the view, as many on either side, with which a G-buffer is GUARD_BAND times as
// wide and as high as the view, or up to two pixels more; so estimators see past the screen's edge. Everything else
// keeps the uv of the view: only the band lies outside 0..1. A geometry module without a param `guard_band` has none.

#include "common/texel.glsl"

#ifndef GUARD_BAND
#define GUARD_BAND 1.0
#endif

// Pixels on either side, in a texture of `size` texels. That is the view and twice the band, and the band is
// ceil(view * (GUARD_BAND - 1) / 2 - 0.01) (core/plan/sizes.cpp). So it is the one whole number that is less
// than half a pixel, divided by GUARD_BAND, from (size - (size - 0.98) / GUARD_BAND) / 2: that, rounded.
highp vec2 bandOf(highp vec2 size)
{
    return GUARD_BAND > 1.0 ? floor(0.5 * (size + 1.0 - (size - 0.98) / GUARD_BAND)) : vec2(0.0);
}

// The view's size in pixels, in a texture of `size` texels.
highp vec2 viewSizeIn(highp vec2 size)
{
    return size - 2.0 * bandOf(size);
}

// What a texture of `size` texels shows is this much of it: 1 without a band.
highp vec2 viewShareOf(highp vec2 size)
{
    return GUARD_BAND > 1.0 ? viewSizeIn(size) / size : vec2(1.0);
}

// The texel at the view's uv, in a texture of `size` texels.
highp ivec2 texelInGuardBand(highp vec2 uv, highp vec2 size)
{
    return texelUnder(uv * viewSizeIn(size), bandOf(size), size);
}

// The view's uv at the centre of a texel, in a texture of `size` texels.
highp vec2 uvFromGuardBand(highp ivec2 texel, highp vec2 size)
{
    return (vec2(texel) + 0.5 - bandOf(size)) / viewSizeIn(size);
}

// Whether a texture with the band holds what lies at the uv of the view. What it holds beyond GUARD_BAND is not taken.
bool isCaptured(highp vec2 uv)
{
    highp vec2 off = abs(uv - 0.5);
    return max(off.x, off.y) < 0.5 * GUARD_BAND;
}
