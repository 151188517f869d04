#version 300 es
// SPDX-License-Identifier: MIT
// An estimator in few lines: how high over the pixel's tangent plane SAMPLES points stand, half a radius away.
//
//   surface  interface: point and normal in view space
//   ao       visibility, 1 open .. 0 blocked; 1 in the background
precision highp float;  // positions and depths

#include <surface>
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/shaders/reach.glsl"

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    vec3 point;
    ao = 1.0;
    if (!viewPosition(uv, point)) return;
    vec3 normal = normalAt(uv);
    float lift = depthTolerance(point, normal, radius);
    float occlusion = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        float angle = 6.28318531 * float(i) / float(SAMPLES);
        vec3 seen;
        if (!viewPosition(uv + 0.5 * reachOf(point) * vec2(cos(angle), sin(angle)), seen)) continue;
        vec3 offset = seen - point;
        if (length(offset) > radius || dot(offset, normal) <= lift) continue;
        occlusion += dot(offset, normal) / length(offset) / float(SAMPLES);
    }
    ao = visibilityOf(occlusion);
}
