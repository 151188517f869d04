// SPDX-License-Identifier: MIT
// Interface `surface`, from stored distances along the view axis and stored normals; works for any projection.
//
//   linear_depth  above 0; 0 or less, LINEAR_FAR or more, and what is no number, in the background
//
// A shader that needs no normals defines SURFACE_WITHOUT_NORMAL before it includes this, so that a plan
// sees that nobody reads them.

#include "common/texel.glsl"
#include "common/view_space.glsl"

uniform highp sampler2D linear_depth;

// View depth that stands for the background: behind everything.
const highp float kBackgroundZ = -1e30;

#ifndef LINEAR_FAR
#define LINEAR_FAR 1e30
#endif

// The point in view space of the texel at uv; false in the background.
bool pointAt(highp vec2 at, out highp vec3 point)
{
    highp vec2 size = vec2(textureSize(linear_depth, 0));
    highp ivec2 texel = texelAt(uvInGuard(at), size);
    highp float stored = texelFetch(linear_depth, texel, 0).r;
    point = viewFromDepth(uvFromGuard((vec2(texel) + 0.5) / size), -stored);
    return stored > 0.0 && stored < LINEAR_FAR;
}

// How far above the tangent plane of `point` its own surface may come out within `reach`: wherever, as normals
// are stored.
highp float offSurface(highp vec3 point, highp vec3 normal, highp float reach)
{
    return (LINEAR_DEPTH_STEP.x + LINEAR_DEPTH_STEP.y * abs(point.z)) * raySlope(point, normal);
}

// View-space z of the texel at uv; kBackgroundZ in the background.
highp float viewZAt(highp vec2 at)
{
    highp vec3 point;
    return pointAt(at, point) ? point.z : kBackgroundZ;
}

#ifndef SURFACE_WITHOUT_NORMAL
uniform mediump sampler2D normal;

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    highp ivec2 texel = texelAt(uvInGuard(at), vec2(textureSize(normal, 0)));
    return normalize(texelFetch(normal, texel, 0).xyz * 2.0 - 1.0);
}
#endif
