#version 300 es
// SPDX-License-Identifier: MIT
// A triangle mesh in a box, seen along one of its edges. Layers of 4 slices each, RESOLUTION / 4 for each edge: first
// those that are seen along x, with y and z across, then y with z and x, then z with x and y.
//
//   place  in voxels
//   uv     texture coordinates of the material
precision highp float;

#include <vertex>

uniform mat4 clip_from_model;  // of the box: -1 to 1 along each edge
uniform highp int first_layer;

out vec3 place;
out vec2 uv;

void main()
{
    vec3 at = (clip_from_model * vec4(modelPoint(), 1.0)).xyz;
    place = (at * 0.5 + 0.5) * float(RESOLUTION);
    uv = modelUv();
    int edge = first_layer / (RESOLUTION / 4);
    gl_Position = vec4(edge == 0 ? at.yz : edge == 1 ? at.zx : at.xy, 0.0, 1.0);
}
