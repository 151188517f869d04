#version 300 es
// SPDX-License-Identifier: MIT
// Occlusion of pixels for which none of `ao` stands, of wires, rungs and leaves: each is marched for itself, over the
// same few texels of depth.
//
//   surface      interface: point and normal in view space, at full size
//   estimator    interface: what is blocked about a point
//   ao_low       has the size of `ao`
//   ao_filtered  visibility, 1 open .. 0 blocked
precision highp float;  // positions and depths; mediump bands
precision highp int;

#define MARCH_FROM_VIEW ao_low
uniform mediump sampler2D ao_low;

#include <surface>
#include <estimator>
#include "ssao/shaders/own_planes.glsl"

in vec2 uv;
layout(location = 0) out float ao_filtered;

void main()
{
    vec3 point;
    bool known = viewPosition(uv, point);
    vec3 normal;
    vec3 plane;
    float tolerance = ownPlanes(uv, point, normal, plane);
    March march;
    marchOf(gl_FragCoord.xy / stride(), shareOfZ(point.z, depthUnit()), normal, plane, tolerance, march);
    ao_filtered = visibilityFrom(march, known);
}
