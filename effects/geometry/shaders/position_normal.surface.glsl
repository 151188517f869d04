// SPDX-License-Identifier: MIT
// Interface `surface`, from stored positions and normals.

#include "common/texel.glsl"
#include "geometry/shaders/host_space.glsl"

uniform highp sampler2D position;

// The point in view space of the texel at uv; false in the background.
bool viewPosition(highp vec2 at, out highp vec3 point)
{
    highp vec4 stored = texelFetch(position, texelAt(at, vec2(textureSize(position, 0))), 0);
    point = viewFromHost(stored.xyz);
    return stored.a > 0.5;
}

// The same as the authors' shaders read it for their taps, where the sampler rounds: cheaper, and at the ties of texels
// the picture of a camera that turns is not quite that of one that does not.
#define SURFACE_AT_TAPS
bool viewPositionAtTap(highp vec2 at, out highp vec3 point)
{
    highp vec4 stored = texture(position, at);
    point = viewFromHost(stored.xyz);
    return stored.a > 0.5;
}

// The size of the surface's texture, and the view depth in one of them about that at uv.
highp ivec2 surfaceSize() { return textureSize(position, 0); }

highp float viewZIn(highp ivec2 texel, highp vec2 at)
{
    highp vec4 stored = texelFetch(position, texel, 0);
    return stored.a > 0.5 ? viewFromHost(stored.xyz).z : -1e15;
}

// How far above the tangent plane of `point` its own surface may come out within `reach`: wherever, as normals
// are stored.
highp float depthTolerance(highp vec3 point, highp vec3 normal, highp float reach)
{
    return dot(POSITION_STEP.x + POSITION_STEP.y * abs(point), abs(normal));
}

#include "geometry/shaders/view_z.glsl"
#include "geometry/shaders/stored_normal.glsl"
