// SPDX-License-Identifier: MIT
// What a tap sees: the surface at its uv, or with DEPTH_LEVELS, far from the pixel, a texel nearby that stands
// for it. Needs the interface `surface` before it, which may define SURFACE_AT_TAPS and have a viewPositionAtTap for
// estimators without GUARDS.

#ifndef DEPTH_LEVELS
#define DEPTH_LEVELS 0
#endif

bool positionAtTap(highp vec2 at, out highp vec3 point)
{
#if defined SURFACE_AT_TAPS && defined GUARDS
#if !GUARDS
    return viewPositionAtTap(at, point);
#endif
#endif
    return viewPosition(at, point);
}

#if DEPTH_LEVELS
#include "common/depth_levels.glsl"
#include "common/view_space.glsl"

uniform highp sampler2D depth_levels;
uniform highp float near_taps;

// The point that the tap at `at` of the pixel at `from` sees, false in the background; `at` becomes the uv of that
// point. The level is the logarithm of the distance, less that of `near_taps`: 16 pixels, where the authors have 2^3.
// [McGuire et al. 2012]
bool samplePosition(highp vec2 from, inout highp vec2 at, out highp vec3 point)
{
    highp ivec2 size = textureSize(depth_levels, 0);
    highp vec2 pixels = (at - from) * viewSizeIn(vec2(size));
    highp float doublings = 0.5 * log2(max(dot(pixels, pixels), 1e-6) / (near_taps * near_taps));
    highp int level = min(int(doublings + 1.0), kDepthLevels);
    if (doublings < 0.0 || min(size.x, size.y) >> level == 0) return positionAtTap(at, point);
    highp ivec2 texel = min(texelInGuardBand(at, vec2(size)) >> level, (size >> level) - 1);
    highp float stored = texelFetch(depth_levels, levelCorner(level, size) + texel, 0).r;
    at = uvFromGuardBand(levelSource(level, texel), vec2(size));
    point = viewFromWindow(at, stored);
    return isDrawn(stored);
}
#else
bool samplePosition(highp vec2 from, highp vec2 at, out highp vec3 point)
{
    return positionAtTap(at, point);
}
#endif
