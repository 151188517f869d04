// SPDX-License-Identifier: MIT
// The interface `surface`'s normalAt, from stored normals. A shader that needs none defines
// SURFACE_WITHOUT_NORMAL before it includes a surface, so that a plan sees that none reads them.

#ifndef SURFACE_WITHOUT_NORMAL
#include "common/guard_band.glsl"
#include "common/view_space.glsl"
#include "geometry/shaders/host_space.glsl"

uniform mediump sampler2D normal;

// The unit normal in view space at uv, towards the camera's side.
highp vec3 normalAt(highp vec2 at)
{
    highp ivec2 texel = texelInGuardBand(at, vec2(textureSize(normal, 0)));
    return viewFromHost(normalize(texelFetch(normal, texel, 0).xyz * 2.0 - 1.0));
}

#ifdef PLANE_STEP  // there is such a target
uniform mediump sampler2D plane;

// The unit normal of the surface's plane at uv: of the triangle that was drawn.
highp vec3 planeAt(highp vec2 at, highp vec3 point, highp vec3 shading)
{
    highp ivec2 texel = texelInGuardBand(at, vec2(textureSize(plane, 0)));
    return normalize(texelFetch(plane, texel, 0).xyz * 2.0 - 1.0);
}
#else
// One over the view depth, or the depth itself of a parallel view: what is straight across the screen on a plane.
highp float straightAt(highp ivec2 texel, highp vec2 at)
{
    highp float z = clamp(viewZIn(clamp(texel, ivec2(0), surfaceSize() - 1), at), -1e15, -1e-15);
#if CAMERA_ORTHOGRAPHIC
    return z;
#else
    return 1.0 / z;
#endif
}

// The change from texel to texel along an axis on the side that continues it better, and by how much it does not.
highp vec2 changeAlong(highp ivec2 texel, highp ivec2 axis, highp float here, highp vec2 at)
{
    highp float before = here - straightAt(texel - axis, at);
    highp float after = straightAt(texel + axis, at) - here;
    highp float off_before = abs(here - before - straightAt(texel - 2 * axis, at) - before);
    highp float off_after = abs(straightAt(texel + 2 * axis, at) - here - after - after);
    return off_before < off_after ? vec2(before, off_before) : vec2(after, off_after);
}

// The way along an axis on the surface, over as many texels as make `noise`, the error of the depth, small. Its length
// is 1 where three of them lie on a line to within kUneven; 0 where that is not so and it is not known.
// `texels` are those of one unit across the view at a distance of 1.
highp vec3 wayAlong(highp vec2 at, highp vec3 point, highp ivec2 texel, highp ivec2 axis, highp vec2 texels,
                    highp float noise)
{
    const highp vec2 kUneven = vec2(0.006, 0.02);  // lean of a texel against the next, as a slope
    highp vec2 across = vec2(axis) / texels;  // of the view at a distance of 1
    highp float width = dot(abs(across), vec2(1.0));
#if !CAMERA_ORTHOGRAPHIC
    width *= -point.z;
#endif
    highp float stride = clamp(ceil(1e3 * noise / width), 1.0, 8.0);
    across *= stride;
    width *= stride;
    axis *= int(stride);
#if CAMERA_ORTHOGRAPHIC
    highp vec2 change = changeAlong(texel, axis, point.z, at);
    highp vec3 way = vec3(across, change.x);
#else
    highp vec2 change = changeAlong(texel, axis, 1.0 / point.z, at) * point.z * point.z;
    highp vec3 way = vec3(-across * point.z, 0.0) - change.x * vec3(point.xy / point.z, 1.0);
#endif
    return normalize(way) * (1.0 - smoothstep(kUneven.x, kUneven.y, (change.y + noise) / width));
}

// The unit normal of the surface's plane at uv, where none was stored: where the stored one, `shading`, leans from
// what is known of that plane by more than kSame, turned to be normal to it. A model of few faces has normals that lean
// by half the angle between them, and a normal map any. Ours.
highp vec3 planeAt(highp vec2 at, highp vec3 point, highp vec3 shading)
{
    const highp vec2 kSame = vec2(0.002, 0.008);  // 1 - the cosine of 4 and 7 degrees
    highp vec2 size = vec2(surfaceSize());
    highp float noise = depthTolerance(point, shading, 0.0);
    highp ivec2 texel = texelInGuardBand(at, size);
    highp vec2 texels = viewSizeIn(size) * 0.5 * vec2(clip_from_view[0][0], clip_from_view[1][1]);
    highp vec3 x = wayAlong(at, point, texel, ivec2(1, 0), texels, noise);
    highp vec3 y = wayAlong(at, point, texel, ivec2(0, 1), texels, noise);
    highp vec3 apart = y - x * dot(x, y);
    y = apart * (length(y) * inversesqrt(max(dot(apart, apart), 1e-12)));
    highp vec3 plane = shading - x * dot(x, shading);
    plane = normalize(plane - y * dot(y, plane) + 1e-4 * shading);
    return normalize(mix(shading, plane, smoothstep(kSame.x, kSame.y, 1.0 - dot(plane, shading))));
}
#endif
#endif
