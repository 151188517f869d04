#version 300 es
// SPDX-License-Identifier: MIT
// Depth of the nearest surface behind another depth; with OR_EQUAL also of one at that depth, as the back of a sheet.
//
//   behind  depth texture of the same size, and of the format of `depth_back`
// [Everitt 2001]
precision highp float;

#include "geometry/shaders/material.glsl"

uniform highp sampler2D behind;

in vec2 uv;

void main()
{
    float nearer = texelFetch(behind, ivec2(gl_FragCoord.xy), 0).r;
#if CAMERA_REVERSED_DEPTH
    float beyond = nearer - gl_FragCoord.z;
#else
    float beyond = gl_FragCoord.z - nearer;
#endif
    // The depth of one surface, as the texture has it and as it comes, differs by less.
    float same = 2.0 * (DEPTH_BACK_STEP.x + DEPTH_BACK_STEP.y * nearer);
#ifdef OR_EQUAL
    if (beyond < -same) discard;
#else
    if (beyond <= same) discard;
#endif
    materialAlbedo(uv);
}
