#version 300 es
// SPDX-License-Identifier: MIT
// Window depth of the camera's projection from a host's logarithmic depth.
//
//   log_depth  log2(1 + log_scale w) / log2(1 + log_scale log_far), where w is the distance along the view
//              axis; 1 in the background
//
// [Kemen 2009, "Logarithmic Depth Buffer", Gamasutra; with log_scale 1 that of three.js]
precision highp float;
precision highp int;

#include "common/texel.glsl"
#include "common/view_space.glsl"

uniform highp sampler2D log_depth;
uniform vec2 viewport_size;
uniform float log_scale;
uniform float log_far;

#if CAMERA_REVERSED_DEPTH
const float kBackground = 0.0;
#else
const float kBackground = 1.0;
#endif

void main()
{
    ivec2 texel = texelAt(gl_FragCoord.xy / viewport_size, vec2(textureSize(log_depth, 0)));
    float stored = texelFetch(log_depth, texel, 0).r;
    float z = -(exp2(max(stored, 0.0) * log2(1.0 + log_scale * log_far)) - 1.0) / log_scale;
    // What is not a number is background, too.
    gl_FragDepth = stored < 1.0 ? windowFromView(z) : kBackground;
}
