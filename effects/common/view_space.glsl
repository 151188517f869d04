// SPDX-License-Identifier: MIT
// Between the screen and view space, for any projection: perspective, off-centre, orthographic.
// View space is right-handed and looks along -z; lengths are in scene units.

#include "common/guard_band.glsl"

uniform highp mat4 clip_from_view;
uniform highp mat4 view_from_window;

// Smallest w divided by: at an infinite far plane w is 0, and lengths up to 1e20 by it must stay below 3e38.
const highp float kSmallestW = 1e-18;

// Whether something was drawn where this depth is stored: the clear left the farthest.
bool isDrawn(highp float window_depth)
{
#if CAMERA_REVERSED_DEPTH
    return window_depth > 0.0;
#else
    return window_depth < 1.0;
#endif
}

// The point in view space behind `uv` at window depth `window_depth`, both in 0..1.
highp vec3 viewFromWindow(highp vec2 uv, highp float window_depth)
{
    highp vec4 view = view_from_window * vec4(uv, window_depth, 1.0);
    return view.xyz / max(view.w, kSmallestW);
}

// The point in view space behind `uv` at view depth `z`. As exact as z is: nothing cancels.
highp vec3 viewFromDepth(highp vec2 uv, highp float z)
{
    highp vec3 ray = (view_from_window * vec4(uv, 0.0, 1.0)).xyz;
#if CAMERA_ORTHOGRAPHIC
    return vec3(ray.xy, z);
#else
    return ray * (z / ray.z);
#endif
}

// View depth at which the ray behind `uv`, within a pixel of `point`, meets the plane through it; on planes that all but
// run along the ray, and on what seems to face away, no further from the point than the plane that leans by kSteepest.
highp float planeZ(highp vec2 uv, highp vec3 point, highp vec3 normal)
{
    const highp float kSteepest = 8.0;  // view depth over way across the view
#if CAMERA_ORTHOGRAPHIC
    highp vec2 way = (view_from_window * vec4(uv, 0.0, 1.0)).xy - point.xy;
    highp float facing = normal.z;
#else
    highp vec3 ray = (view_from_window * vec4(uv, 0.0, 1.0)).xyz;
    highp vec2 way = ray.xy * (point.z / ray.z) - point.xy;
    highp float facing = dot(normal, ray / ray.z);
#endif
    highp vec2 slope = clamp(-normal.xy / max(facing, 1e-6), -kSteepest, kSteepest);
    return point.z + dot(way, slope);
}

// The window depth that viewFromWindow takes to view depth `z`: (m2.z d + near.z) / (m2.w d + near.w) = z, solved for d,
// where an oblique near plane has `near` change over the screen [Lengyel 2005]. Nothing cancels: reversed depth keeps
// the digits that a float texture has for it.
highp float windowFromView(highp vec2 uv, highp float z)
{
    highp mat4 m = view_from_window;
    highp vec4 near = m[0] * uv.x + m[1] * uv.y + m[3];
    return clamp((near.z - z * near.w) / (z * m[2].w - m[2].z), 0.0, 1.0);
}

// One scene unit across the view at a point in view space, in uv.
highp vec2 uvOfUnit(highp vec3 point)
{
#if CAMERA_ORTHOGRAPHIC
    const highp float w = 1.0;
#else
    highp float w = -point.z;
#endif
    return 0.5 / w * vec2(clip_from_view[0][0], clip_from_view[1][1]);
}

// How far apart in view depth two points about `point` may come out that are one, where window depth is
// stored in steps of `stored` (absolute, and a share of the value): by the steps, times the derivative of
// viewFromWindow, and by one rounding of each sum above.
highp float viewStepOf(highp vec2 stored, highp vec3 point)
{
    const highp float kEpsilon = 1.2e-7;  // 2^-23, of 32-bit floats
    highp mat4 m = view_from_window;
    highp vec4 clip = clip_from_view * vec4(point, 1.0);
    highp float share = max(clip.w, kSmallestW);  // of which viewFromWindow finds the inverse
    highp float window = clamp(0.5 * clip.z / share + 0.5, 0.0, 1.0);
    highp float slope = abs(m[2].z - point.z * m[2].w) * (stored.x + stored.y * window);
    highp vec2 others = abs(m[0].zw) + abs(m[1].zw) + abs(m[3].zw);  // at any uv
    highp vec2 sums = abs(m[2].zw) * window + others;
    return (slope + kEpsilon * (sums.x + abs(point.z) * sums.y)) * share;
}

// How far a point moves along `normal` while its view depth changes by 1 and it stays behind its pixel.
highp float raySlope(highp vec3 point, highp vec3 normal)
{
#if CAMERA_ORTHOGRAPHIC
    return abs(normal.z);
#else
    return abs(dot(point, normal) / min(point.z, -kSmallestW));
#endif
}

// The uv onto which `point` projects; false behind the camera, and beyond the screen and its guard band.
bool uvFromView(highp vec3 point, out highp vec2 uv)
{
    highp vec4 clip = clip_from_view * vec4(point, 1.0);
    uv = clip.xy / max(clip.w, kSmallestW) * 0.5 + 0.5;
    return clip.w > 0.0 && isCaptured(uv);
}
