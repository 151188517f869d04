// SPDX-License-Identifier: MIT
// Interface `surface`, from stored positions and normals.
//
// A shader that needs no normals defines SURFACE_WITHOUT_NORMAL before it includes this, so that a plan
// sees that nobody reads them.

uniform highp sampler2D position;

// View depth that stands for the background: behind everything.
const highp float kBackgroundZ = -1e30;

// The point in view space at uv; false in the background.
bool pointAt(highp vec2 at, out highp vec3 point)
{
    highp vec4 stored = texture(position, at);
    point = stored.xyz;
    return stored.a > 0.5;
}

// How far above its own surface, along `normal`, a point may come out.
highp float offSurface(highp vec3 point, highp vec3 normal)
{
    return dot(POSITION_STEP.x + POSITION_STEP.y * abs(point), abs(normal));
}

// View-space z at uv; kBackgroundZ in the background.
highp float viewZAt(highp vec2 at)
{
    highp vec4 stored = texture(position, at);
    return stored.a > 0.5 ? stored.z : kBackgroundZ;
}

#ifndef SURFACE_WITHOUT_NORMAL
uniform mediump sampler2D normal;

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    return normalize(texture(normal, at).xyz * 2.0 - 1.0);
}
#endif
