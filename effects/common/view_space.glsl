// SPDX-License-Identifier: MIT
// Between the screen and view space, for any projection: perspective, off-centre, orthographic.
// View space is right-handed and looks along -z; lengths are in scene units.

#include "common/guard.glsl"

uniform highp mat4 clip_from_view;
uniform highp mat4 view_from_clip;

// Smallest w divided by: at an infinite far plane w is 0, and the quotient must stay finite in float.
const highp float kSmallestW = 1e-18;

// The point in view space behind `uv` at window depth `window_depth`, both in 0..1.
highp vec3 viewFromWindow(highp vec2 uv, highp float window_depth)
{
    highp vec4 view = view_from_clip * (vec4(uv, window_depth, 1.0) * 2.0 - 1.0);
    return view.xyz / max(view.w, kSmallestW);
}

// The uv onto which `point` projects; false when the camera cannot see there: behind it, or beyond the
// screen and its guard band.
bool uvFromView(highp vec3 point, out highp vec2 uv)
{
    highp vec4 clip = clip_from_view * vec4(point, 1.0);
    uv = clip.xy / max(clip.w, kSmallestW) * 0.5 + 0.5;
    return clip.w > 0.0 && isCaptured(uv);
}
