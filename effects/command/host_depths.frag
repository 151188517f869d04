#version 300 es
// SPDX-License-Identifier: MIT
// Depth as hosts store it in colour textures.
//
//   host_depth      window depth
//   host_distance   along the view axis, scene units; 0 in the background
//   host_log_depth  log2(1 + log_scale w) / log2(1 + log_scale log_far) of distance w; 1 in the background
precision highp float;

#define SURFACE_WITHOUT_NORMAL
#include <surface>

uniform float log_far;
uniform float log_scale;

in vec2 uv;
layout(location = 0) out float host_depth;
layout(location = 1) out float host_distance;
layout(location = 2) out float host_log_depth;

void main()
{
    vec3 point;
    bool seen = viewPosition(uv, point);
    host_depth = texture(depth, uv).r;
    host_distance = seen ? -point.z : 0.0;
    host_log_depth = seen ? log2(1.0 - log_scale * point.z) / log2(1.0 + log_scale * log_far) : 1.0;
}
