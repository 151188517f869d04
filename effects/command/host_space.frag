#version 300 es
// SPDX-License-Identifier: MIT
// Normals and positions as hosts store them, in their own view space.
//
//   host_normal    n * 0.5 + 0.5
//   host_position  scene units; alpha 1 on a surface, 0 in the background
precision highp float;

#include "common/host_picture.glsl"
#include <surface>

in vec2 uv;
layout(location = 0) out vec4 host_normal;
layout(location = 1) out vec4 host_position;

vec3 hostFromView(vec3 vector)
{
#if CAMERA_TURNED
    return vector * view_from_host;  // turns and mirrors, so that its inverse is its transpose
#else
    return vector;
#endif
}

void main()
{
    vec3 point;
    bool seen = viewPosition(uv, point);
    host_position = vec4(seen ? hostFromView(point) : vec3(0.0), float(seen));
    host_normal = vec4((seen ? hostFromView(normalAt(uv)) : vec3(0.0)) * 0.5 + 0.5, float(seen));
}
