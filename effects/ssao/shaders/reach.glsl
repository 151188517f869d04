// SPDX-License-Identifier: MIT
// How far the radius reaches across the screen.

#include "common/view_space.glsl"

uniform highp float radius;

// One radius about a point in view space, in uv.
highp vec2 reachOf(highp vec3 point)
{
    return radius * uvOfUnit(point);
}

// 1 where the radius is two pixels or more, 0 where it is below one: no tap is as near, and there is nothing
// to see. Ours; XeGTAO fades as well, from ten pixels on.
highp float radiusFade(highp vec2 reach, highp vec2 pixel)
{
    highp vec2 pixels = reach / pixel;
    return clamp(max(pixels.x, pixels.y) - 1.0, 0.0, 1.0);
}
