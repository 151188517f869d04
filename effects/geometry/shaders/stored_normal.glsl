// SPDX-License-Identifier: MIT
// The interface `surface`'s normalAt, from stored normals. A shader that needs none defines
// SURFACE_WITHOUT_NORMAL before it includes a surface, so that a plan sees that none reads them.

#ifndef SURFACE_WITHOUT_NORMAL
#include "common/guard_band.glsl"
#include "geometry/shaders/host_space.glsl"

uniform mediump sampler2D normal;

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    highp ivec2 texel = texelInGuardBand(at, vec2(textureSize(normal, 0)));
    return viewFromHost(normalize(texelFetch(normal, texel, 0).xyz * 2.0 - 1.0));
}
#endif
