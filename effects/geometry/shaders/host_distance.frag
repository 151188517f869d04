#version 300 es
// SPDX-License-Identifier: MIT
// Window depth of the camera's projection from a host's distances along the view axis.
//
//   LOGARITHMIC   what the host stores
//   log_depth     log2(1 + log_scale w) / log2(1 + log_scale log_far) of distance w; 1 in the background
//   linear_depth  the distance; 0 or less, linear_far or more, and what is no number, in the background
//
// [Kemen 2009; with log_scale 1 that of three.js]
precision highp float;
precision highp int;

#include "common/texel.glsl"
#include "common/view_space.glsl"

uniform vec2 viewport_size;

#if LOGARITHMIC
uniform highp sampler2D log_depth;
uniform float log_scale;
uniform float log_far;
#else
uniform highp sampler2D linear_depth;
uniform float linear_far;
#endif

float storedIn(highp sampler2D image)
{
    return texelFetch(image, texelAt(gl_FragCoord.xy / viewport_size, vec2(textureSize(image, 0))), 0).r;
}

void main()
{
#if LOGARITHMIC
    float stored = storedIn(log_depth);
    bool known = stored < 1.0;
    float distance = (exp2(max(stored, 0.0) * log2(1.0 + log_scale * log_far)) - 1.0) / log_scale;
#else
    float distance = storedIn(linear_depth);
    bool known = distance > 0.0 && distance < linear_far;
#endif
#if CAMERA_REVERSED_DEPTH
    const float kBackground = 0.0;
#else
    const float kBackground = 1.0;
#endif
    gl_FragDepth = known ? windowFromView(gl_FragCoord.xy / viewport_size, -distance) : kBackground;
}
