#version 300 es
// SPDX-License-Identifier: MIT
// The surface's normals at the resolution of the occlusion, so that filters read those of neighbours at a fetch each,
// also where the surface rebuilds them.
//
//   surface     interface: normal in view space
//   normal_low  stored as n * 0.5 + 0.5
precision highp float;  // positions are compared

#define WIDEST_NORMAL 1
#include <surface>

in vec2 uv;
layout(location = 0) out vec4 normal_low;

void main()
{
    normal_low = vec4(normalAt(uv) * 0.5 + 0.5, 1.0);
}
