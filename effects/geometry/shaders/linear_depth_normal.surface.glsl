// SPDX-License-Identifier: MIT
// Interface `surface`, from stored distances along the view axis and stored normals; works for any projection.
//
//   linear_depth  above 0; 0 or less, LINEAR_FAR or more, and what is no number, in the background

#include "common/view_space.glsl"

uniform highp sampler2D linear_depth;

#ifndef LINEAR_FAR
#define LINEAR_FAR 1e30
#endif

// The point in view space of the texel at uv; false in the background.
bool viewPosition(highp vec2 at, out highp vec3 point)
{
    highp vec2 size = vec2(textureSize(linear_depth, 0));
    highp ivec2 texel = texelInGuardBand(at, size);
    highp float stored = texelFetch(linear_depth, texel, 0).r;
    point = viewFromDepth(uvFromGuardBand(texel, size), -stored);
    return stored > 0.0 && stored < LINEAR_FAR;
}

// The size of the surface's texture, and the view depth in one of them about that at uv.
highp ivec2 surfaceSize() { return textureSize(linear_depth, 0); }

highp float viewZIn(highp ivec2 texel, highp vec2 at)
{
    highp float stored = texelFetch(linear_depth, texel, 0).r;
    return stored > 0.0 ? -stored : -1e15;
}

// How far above the tangent plane of `point` its own surface may come out within `reach`: wherever, as normals
// are stored.
highp float depthTolerance(highp vec3 point, highp vec3 normal, highp float reach)
{
    return (LINEAR_DEPTH_STEP.x + LINEAR_DEPTH_STEP.y * abs(point.z)) * raySlope(point, normal);
}

#include "geometry/shaders/view_z.glsl"
#include "geometry/shaders/stored_normal.glsl"
