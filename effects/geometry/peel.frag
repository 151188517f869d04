#version 300 es
// SPDX-License-Identifier: MIT
// Depth of the nearest surface behind another depth.
//
//   behind  depth texture of the same size
// [Everitt 2001, "Interactive Order-Independent Transparency"]
precision highp float;

#include "geometry/material.glsl"

uniform highp sampler2D behind;

in vec2 uv;

void main()
{
    if (gl_FragCoord.z <= texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r) discard;
    materialAlbedo(uv);
}
