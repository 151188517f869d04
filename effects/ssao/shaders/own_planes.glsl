// SPDX-License-Identifier: MIT
// What marching estimators take of the interface `surface` at a pixel: the normal that weighs light, that of the plane,
// and how far off that the surface may come out, as it is stored (common/tolerance.glsl).

#include "common/depth_share.glsl"
#include "common/tolerance.glsl"
#include "ssao/shaders/shading_normals.glsl"

mediump float ownPlanes(highp vec2 at, highp vec3 point, out highp vec3 normal, out highp vec3 plane)
{
    normal = normalAt(at);
    if (!(dot(normal, normal) < 2.0)) normal = vec3(0.0, 0.0, 1.0);  // a host's that are no numbers
    plane = normal;
#if SHADING_NORMALS
    plane = planeAt(at, point, normal);
    if (!(dot(plane, plane) < 2.0)) plane = normal;  // beside depths that are no numbers
#endif
    return storedTolerance(depthTolerance(point, plane, 0.0) / usedRadius());
}
