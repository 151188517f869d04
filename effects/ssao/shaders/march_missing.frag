#version 300 es
// SPDX-License-Identifier: MIT
// Occlusion of pixels for which none of `ao` stands, of wires, rungs and leaves: each is marched for itself, over the
// same few texels of depth.
//
//   surface      interface: point and planes in view space, at full size; light is weighed by those, too: another normal
//                would take more registers than a phone has, and of pixels so thin no error is smaller for it
//   estimator    interface: what is blocked about a point
//   ao_low       has the size of `ao`
//   ao_filtered  visibility, 1 open .. 0 blocked
precision highp float;  // positions and depths; mediump bands
precision highp int;

#define MARCH_FROM_VIEW ao_low
uniform mediump sampler2D ao_low;

#include <surface>
#include "ssao/shaders/own_planes.glsl"
#undef SHADING_NORMALS
#define SHADING_NORMALS 0
#include <estimator>

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
    marchOf(gl_FragCoord.xy / stride(), shareOfZ(point.z, depthUnit()), plane, plane, tolerance, march);
    ao_filtered = visibilityFrom(march, known);
}
