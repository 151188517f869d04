// SPDX-License-Identifier: MIT
// How much a neighbour counts: less the farther it and the pixel are from one plane, both by itself and as a slope, so
// that neither a step nor an edge is smoothed over. A plane is filtered alike however it lies to the camera.
//
// Depths are shares (common/depth_share.glsl), which run almost straight over the screen on a plane. Both weights fall
// in a straight line, which is ours.
//
//   source_normal  normals of planes at the size of the occlusion, with the guard band, and tolerances; with
//                  SHADING_NORMALS source_plane has them
//
// [Tomasi, Manduchi 1998]

#include "common/pixel_ray.glsl"
#include "common/tolerance.glsl"
#include "ssao/shaders/shading_normals.glsl"

#if SHADING_NORMALS
#define source_normal source_plane
#endif
uniform mediump sampler2D source_normal;
uniform highp float depth_cut;
uniform highp float slope_cut;

highp vec3 normalOf(mediump vec4 stored) { return stored.xyz * 2.0 - 1.0; }

// How much the view depth changes with the share.
highp float lengthPerShare(highp float share)
{
#if CAMERA_ORTHOGRAPHIC
    highp float kept = clamp(min(share, 1.0 - share), kFarthestShare, 0.5);
    return 0.5 * depthUnit() / (kept * kept);
#else
    highp float inverse = 1.0 / max(share, kFarthestShare);
    return depthUnit() * inverse * inverse;
#endif
}

// The length off the plane at which a neighbour no longer counts. With the filter off what takes occlusion to full size
// still goes by depth.
highp float depthCut() { return max((depth_cut > 0.0 ? depth_cut : 0.05) * radius, 1e-20); }

// Of lengths off the plane, in cuts: at 1 and more a neighbour does not count. `noise` is what the points and the normal
// may be off, `per_way` one over the lengths of the ways there.
highp vec4 cutsOf(highp vec4 off, highp float noise, highp vec4 per_way)
{
    highp vec4 slopes = max(off - noise, 0.0) * per_way;
    return min(off / depthCut() + slopes / slope_cut, 1e4);
}

// The same of one length, from a pixel to a neighbour `width` away with the plane `stored`, or the other way round.
highp float cutOf(highp float off, mediump vec4 stored, highp float width)
{
    return cutsOf(vec4(abs(off)), 4.0 * toleranceOf(stored.a) * radius, vec4(1.0 / max(width, 1e-20))).x;
}

// Whether a length off the plane of a neighbour `width` away is so small that the neighbour counts as on it: within this
// share of either cut. From 0.1 to 0.8 errors differ by 0.0001 in rmse, and fetches by 5 %.
bool isOnPlane(highp float off, highp float width)
{
    const highp float kFlat = 0.3;
    return off < kFlat * min(depthCut(), slope_cut * width);
}

// Whether the pixels of `shares`, to the `right`, `above` and both, lie so near the plane of a pixel; not in the background.
bool isFlat(highp vec2 right, highp vec2 above, highp float share, highp vec3 shares, mediump vec4 stored)
{
    highp float facing = dot(normalOf(stored), rayThrough(gl_FragCoord.xy));
    highp vec2 size = pixelSize(share);
    highp vec2 rise = normalOf(stored).xy * size;
    highp vec3 off = abs(facing * (shares - share) * lengthPerShare(share) +
                         vec3(dot(rise, right), dot(rise, above), dot(rise, right + above)));
    highp float noise = 4.0 * toleranceOf(stored.a) * radius;
    return share > 0.0 && isOnPlane(max(max(off.x, off.y), off.z) - noise, abs(size.x));
}

// How far it is on the plane from a pixel to the next along an axis, in scene units.
highp float wayAlong(highp vec2 axis, highp float share, mediump vec4 stored)
{
    highp vec2 way = axis * pixelSize(share);
    highp vec3 ray = rayThrough(gl_FragCoord.xy);
    highp float facing = dot(normalOf(stored), ray);
    highp float deeper = -dot(normalOf(stored).xy, way) / (abs(facing) > 1e-3 ? facing : 1e-3);
    return length(vec3(way, 0.0) + deeper * ray);
}

// Weights of the pixels two and one before, one and two after along an axis, the outer ones by half, from their shares
// and that of the pixel between. `stored` is what source_normal has there.
highp vec4 weightsAlong(highp vec2 axis, highp float share, highp vec4 shares, mediump vec4 stored)
{
    const highp vec4 kHalf = vec4(0.5, 1.0, 1.0, 0.5);
    highp float facing = dot(normalOf(stored), rayThrough(gl_FragCoord.xy));
    highp vec2 size = pixelSize(share);
    highp vec4 behind = (shares - share) * lengthPerShare(share);
    highp float rise = dot(normalOf(stored).xy * size, axis);
    highp vec4 off = abs(facing * behind + rise * vec4(-2.0, -1.0, 1.0, 2.0));
    highp float noise = 4.0 * toleranceOf(stored.a) * radius + 2.0 * shareStep(share);
    highp float per_way = 1.0 / max(size.x, 1e-20);
    return depth_cut > 0.0 ? max(1.0 - cutsOf(off, noise, per_way * kHalf), 0.0) * kHalf : vec4(0.0);
}
