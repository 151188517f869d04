#version 300 es
// SPDX-License-Identifier: MIT
// Depth of the nearest surface behind another depth.
//
//   behind  depth texture of the same size
// [Everitt 2001, "Interactive Order-Independent Transparency"]
precision highp float;

#include "geometry/shaders/material.glsl"

uniform highp sampler2D behind;

in vec2 uv;

void main()
{
    float nearer = texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r;
#if CAMERA_REVERSED_DEPTH
    if (gl_FragCoord.z >= nearer) discard;
#else
    if (gl_FragCoord.z <= nearer) discard;
#endif
    materialAlbedo(uv);
}
