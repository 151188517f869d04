#version 300 es
// SPDX-License-Identifier: MIT
// What marching estimators and their filters read of the surface, at the size of the occlusion, with the guard band.
//
//   surface        interface: point and normal in view space
//   source_depth   view depth as a share (common/depth_share.glsl); 0 in the background
//   source_normal  normal in view space, stored as n * 0.5 + 0.5, and in alpha how far off its plane the surface may
//                  come out (common/tolerance.glsl)
//   source_plane   with SHADING_NORMALS, the same of the plane: what source_normal has there only weighs light
//
// Each texel stands for one texel of the surface, whose plane it meets at its own middle: so a plane stays one.
precision highp float;  // positions and depths
precision highp int;

#include <surface>
#include "common/middle_pixel.glsl"
#include "ssao/shaders/own_planes.glsl"

uniform vec2 viewport_size;

layout(location = 0) out vec4 source_normal;
#if SHADING_NORMALS
layout(location = 1) out vec4 source_plane;
#endif

void main()
{
    vec2 at = uvFromGuardBand(ivec2(gl_FragCoord.xy), viewport_size);
    vec2 seen = seenUv(at, viewSizeIn(viewport_size));
    vec3 point;
    if (!viewPosition(seen, point)) {
        source_normal = vec4(0.0);
#if SHADING_NORMALS
        source_plane = vec4(0.0);
#endif
        gl_FragDepth = 0.0;
        return;
    }
    vec3 normal;
    vec3 plane;
    float tolerance = ownPlanes(seen, point, normal, plane);
    source_normal = vec4(normal * 0.5 + 0.5, tolerance);
#if SHADING_NORMALS
    source_plane = vec4(plane * 0.5 + 0.5, tolerance);
#endif
    gl_FragDepth = shareOfZ(planeZ(at, point, plane), depthUnit());
}
