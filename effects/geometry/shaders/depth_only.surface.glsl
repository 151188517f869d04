// SPDX-License-Identifier: MIT
// Interface `surface`, from depth alone; works for any projection. A normal costs nine fetches.

#include "geometry/shaders/depth_point.glsl"

uniform highp sampler2D depth;

// The point in view space of the texel at uv; false in the background.
bool viewPosition(highp vec2 at, out highp vec3 point)
{
    return pointIn(depth, at, point);
}

#include "geometry/shaders/view_z.glsl"

#ifndef SURFACE_WITHOUT_NORMAL
#include "geometry/shaders/normal_from_depth.glsl"

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    return rebuiltNormal(depth, DEPTH_STEP, at);
}

// How far above the tangent plane of `point` its own surface may come out within `reach`.
highp float depthTolerance(highp vec3 point, highp vec3 normal, highp float reach)
{
    highp float rise = rebuiltRise(vec2(textureSize(depth, 0)), DEPTH_STEP, point, normal, reach);
    return viewStepOf(DEPTH_STEP, point) * raySlope(point, normal) + rise;
}
#endif
