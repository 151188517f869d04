#version 300 es
// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion.
//
//   surface  interface: point and normal in view space
//   ao       visibility, 1 open .. 0 blocked; 1 in the background
//
// [Bavoil, Sainz 2008, "Image-Space Horizon-Based Ambient Occlusion"]
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include <surface>
#include "ssao/shaders/hbao.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

uniform vec2 viewport_size;

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    vec3 point;
    if (!viewPosition(uv, point)) {
        ao = 1.0;
        return;
    }
    vec2 at = hostPixel(gl_FragCoord.xy, viewport_size);
    March march = marchFrom(uv, at, vec2(dFdx(uv.x), dFdy(uv.y)), point, normalAt(uv));
    ao = visibilityOf(occlusionOf(march));
}
