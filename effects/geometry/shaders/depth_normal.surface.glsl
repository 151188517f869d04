// SPDX-License-Identifier: MIT
// Interface `surface`, from depth and stored normals; works for any projection.

#include "geometry/shaders/depth_point.glsl"

uniform highp sampler2D depth;

// The point in view space of the texel at uv; false in the background.
bool viewPosition(highp vec2 at, out highp vec3 point)
{
    return pointIn(depth, at, point);
}

// The size of the surface's texture, and the view depth in one of them about that at uv.
highp ivec2 surfaceSize() { return textureSize(depth, 0); }

highp float viewZIn(highp ivec2 texel, highp vec2 at)
{
    highp float stored = texelFetch(depth, texel, 0).r;
    highp vec2 view = (view_from_window * vec4(at, stored, 1.0)).zw;
    return view.x / max(view.y, kSmallestW);
}

// How far above the tangent plane of `point` its own surface may come out within `reach`: wherever, as normals
// are stored.
highp float depthTolerance(highp vec3 point, highp vec3 normal, highp float reach)
{
    return viewStepOf(DEPTH_STEP, point) * raySlope(point, normal);
}

#include "geometry/shaders/view_z.glsl"
#include "geometry/shaders/stored_normal.glsl"
