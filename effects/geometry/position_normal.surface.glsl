// SPDX-License-Identifier: MIT
// Interface `surface`, from stored positions and normals.
//
// A shader that needs no normals defines SURFACE_WITHOUT_NORMAL before it includes this, so that a plan
// sees that nobody reads them.

#include "common/texel.glsl"

uniform highp sampler2D position;

// View depth that stands for the background: behind everything.
const highp float kBackgroundZ = -1e30;

highp vec4 storedAt(highp vec2 at)
{
    return texelFetch(position, texelAt(at, vec2(textureSize(position, 0))), 0);
}

// The point in view space of the texel at uv; false in the background.
bool pointAt(highp vec2 at, out highp vec3 point)
{
    highp vec4 stored = storedAt(at);
    point = stored.xyz;
    return stored.a > 0.5;
}

// How far above the tangent plane of `point` its own surface may come out within `reach`: wherever, as normals
// are stored.
highp float offSurface(highp vec3 point, highp vec3 normal, highp float reach)
{
    return dot(POSITION_STEP.x + POSITION_STEP.y * abs(point), abs(normal));
}

// View-space z of the texel at uv; kBackgroundZ in the background.
highp float viewZAt(highp vec2 at)
{
    highp vec4 stored = storedAt(at);
    return stored.a > 0.5 ? stored.z : kBackgroundZ;
}

#ifndef SURFACE_WITHOUT_NORMAL
uniform mediump sampler2D normal;

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    highp ivec2 texel = texelAt(at, vec2(textureSize(normal, 0)));
    return normalize(texelFetch(normal, texel, 0).xyz * 2.0 - 1.0);
}
#endif
