// SPDX-License-Identifier: MIT
// What voxels tell of the sectors that ssao/shaders/bitmask.glsl has found nothing in: one ray a side, into one of them,
// stands for them all. A voxel counts where the screen does not show that the place is empty.
//
//   voxels  interface: how much of a place surfaces fill, as seen along each edge of a box
//
// Ours. Rays take even steps of the voxels' mips, so that time does not grow with the radius. Figures are means of rmse
// over 16 scenes of tests/unseen/scenes.py (104 to 119), of a radius and of three times that: 0.055 and 0.065, in
// balanced 0.061 and 0.084.

#include "common/angles.glsl"
#include "ssao/shaders/march.glsl"
#include "ssao/bitmask/sectors.glsl"
#include <voxels>

// With three 0.0005 and 0.001 more at 0.93 of the time, with five 0.0004 and 0.001 less at 1.07.
const int kRaySteps = 4;
const mediump float kRayFirst = 0.7;  // voxels along a ray to its first step
// How far in front of what the screen shows, in voxels of a step, a place is taken for empty: from, and altogether.
// Without the test 0.061 and 0.078.
const mediump vec2 kSeenEmpty = vec2(0.0, 0.6);

// More than a step's mean opacity, since steps straddle walls: with 1 visibility beside one that the screen does not show
// is 0.05 too high, with 1.2 less than 0.03 (tests/effects/voxels_gl_test.cpp). Mean errors are the same.
const mediump float kOpaque = 1.2;

// Where a pixel's rays begin.
struct Voxelled {
    bool known;           // there are voxels
    Voxels voxels;
    mediump float size;   // of one, in radii of the march; large where there are none
    mediump float reach;  // the radius in voxels, no more than a box has
    highp vec3 place;     // the point, in the box
    mediump vec3 own;     // the surface's normal along each edge
};

Voxelled voxelled(March march)
{
    Voxelled at;
    highp vec3 point = march.point * march.radius;
    at.known = findVoxels(point, march.noise.x, at.voxels);
    at.size = at.known ? clamp(at.voxels.size / march.radius, 1e-3, 1e3) : 1e3;
    at.reach = min(usedRadius() / at.voxels.size, 2.0 * float(RESOLUTION));
    at.place = (boxFromView(at.voxels.box) * vec4(point, 1.0)).xyz;
    at.own = ownFilling(at.voxels, march.plane);
    return at;
}

// The middle of a set bit, with `share` of all that are set below it, to within eight bits. [Anderson 2005 - counting]
mediump float bitAbove(uint mask, mediump float share)
{
    highp uint sums = bytesOf(mask) * 0x01010101u;  // of each byte and those below
    mediump vec4 below = vec4(uvec4(sums, sums >> 8u, sums >> 16u, sums >> 24u) & 255u);
    mediump float wanted = share * below.w;
    mediump vec3 passed = step(below.xyz, vec3(wanted));
    mediump vec4 in_byte = vec4(1.0, passed) - vec4(passed, 0.0);
    mediump float before = dot(in_byte.yzw, below.xyz);
    mediump float bits = dot(in_byte, below) - before;
    return min(8.0 * (dot(passed, vec3(1.0)) + (wanted - before) / max(bits, 1.0)) + 0.5, kSectors);
}

// The unit vector into a sector. Light between the plane and the camera grows with the product of the sines of the angles
// to both; a polynomial that is right at both ends turns its share into one of the angle.
mediump vec2 wayInto(Side side, mediump float sector)
{
    mediump float share = 2.0 / kSectors * sector - 1.0;
    mediump float square = share * share;
    mediump float angle = angleOf(side.towards.x) * (0.5 + share * (0.31 + 0.19 * square * square));
    return vec2(cos(angle), sin(angle));
}

// How far in front of what the screen shows a point lies, in radii; less than 0 where it is hidden.
mediump float aheadOfSeen(March march, highp vec3 point)
{
    highp vec2 ray = point.xy;
#if CAMERA_ORTHOGRAPHIC
    ray *= march.radius;
    bool before = true;
#else
    bool before = point.z < 0.0;
    ray /= before ? point.z : -1.0;
#endif
    highp vec2 pixel = (ray - ray_from_pixel[2].xy) / (stride() * vec2(ray_from_pixel[0].x, ray_from_pixel[1].y));
    highp ivec2 texel = ivec2(floor(pixel)) + march.band;
    highp ivec2 last = textureSize(source_depth, 0) - 1;
    highp ivec2 kept = clamp(texel, ivec2(0), last);
    highp float share = max(texelFetch(source_depth, kept, 0).r, kFarthestShare);
    return before && kept == texel ? min(point.z - zOfShare(share, march.unit), kFar) : -kFar;
}

// How many sectors of those that are not in `mask` voxels block. `i` is the side's number.
mediump float blockedByVoxels(March march, Voxelled at, Side side, uint mask, int i)
{
    uint open_mask = ~mask & 0x7fffffffu;
    mediump vec2 shift = fract(vec2(3.0 * march.noise.x + 0.03125, march.noise.y) + vec2(0.4375, 0.618) * float(i));
    mediump vec2 into = wayInto(side, bitAbove(open_mask, 0.25 + 0.5 * shift.x));
    mediump vec3 up = side.towards.y * toCamera(march.pixel) - side.towards.x * side.along;
    mediump vec3 way = into.x * side.x + into.y * up;
    mediump float height = max(dot(way, march.plane), 0.02);
    highp vec3 step_in_box = mat3(boxFromView(at.voxels.box)) * way * at.voxels.size;  // of one voxel
    mediump vec3 along = abs(step_in_box) * float(RESOLUTION);
    mediump float stride = max(at.reach - kRayFirst, 0.0) / float(kRaySteps);
    mediump float level = max(floor(log2(max(stride, 1.0) / 1.5) + 0.5), 0.0);
    mediump float width = exp2(level);
    mediump float open = 1.0;
    for (int k = 0; k < kRaySteps; ++k) {
        mediump float far = kRayFirst + stride * (float(k) + 0.5);
        mediump vec3 filled = fillingAt(at.voxels, at.place + far * step_in_box, level);
        mediump float over = far * height / width;
        mediump float ahead = aheadOfSeen(march, march.point + far * at.size * way) / (width * at.size);
        filled = withoutOwn(filled, at.own, width, over) * (1.0 - smoothstep(kSeenEmpty.x, kSeenEmpty.y, ahead));
        // Lower than a voxel and next to what is seen, it may be the surface beyond a convex edge.
        if (ahead > -1.5) filled *= clamp(1.5 * over - 0.5, 0.0, 1.0);
        open *= 1.0 - min(kOpaque * dot(filled, along) * stride, 1.0);
    }
    return at.known ? countOf(open_mask) * (1.0 - open) : 0.0;
}
