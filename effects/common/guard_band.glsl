// SPDX-License-Identifier: MIT
// The guard band: a G-buffer that is GUARD_BAND times as wide and as high as the view, so that estimators see
// past the screen's edge. Everything else keeps the uv of the view; only what the band adds lies outside
// 0..1. A geometry module that has no param `guard_band` has no band.

#ifndef GUARD_BAND
#define GUARD_BAND 1.0
#endif

// Where the uv of the view lies in a texture that has the band.
highp vec2 uvInGuardBand(highp vec2 uv)
{
    return (uv - 0.5) / GUARD_BAND + 0.5;
}

// The uv of the view at a place in a texture that has the band.
highp vec2 uvFromGuardBand(highp vec2 place)
{
    return (place - 0.5) * GUARD_BAND + 0.5;
}

// Whether a texture with the band holds what lies at the uv of the view.
bool isCaptured(highp vec2 uv)
{
    highp vec2 off = abs(uv - 0.5);
    return max(off.x, off.y) < 0.5 * GUARD_BAND;
}
