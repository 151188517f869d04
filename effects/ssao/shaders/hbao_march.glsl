// SPDX-License-Identifier: MIT
// What the estimators that march over the screen share: the pixel's slices and where their taps lie.

#include "common/host_picture.glsl"
#include "common/pixel_noise.glsl"
#include "ssao/shaders/reach.glsl"
#include "ssao/shaders/seen.glsl"
#include "ssao/shaders/slice.glsl"

uniform highp float bias;

const highp float kPi = 3.14159265;

// The slices of one pixel.
struct March {
    highp vec3 point;      // view space, lifted off its own surface
    highp vec3 normal;
    highp vec3 to_camera;  // unit; with `right` and `up` a frame about the view ray
    highp vec3 right;
    highp vec3 up;
    highp vec3 clip;       // x, y and w of the point in clip space
    highp float reach;     // how far along a slice one radius is seen, in scene units
    highp vec2 shown;      // one radius across the middle of the screen, in uv
    highp vec2 uv;
    highp vec2 pixel;      // one pixel, in uv
    highp vec2 noise;      // 0..1: turns the slices, shifts the taps
};

highp vec3 clipOf(highp vec4 place)
{
    return (clip_from_view * place).xyw;
}

// How far from the middle a sphere of one radius ends for the eye, measured across the view ray: at the distance d
// R / sqrt(1 - R^2 / d^2), and at most sqrt(5) R, since an eye within the sphere sees no end. That bound is ours.
highp float seenReach(highp vec3 point)
{
#if CAMERA_ORTHOGRAPHIC
    return radius;
#else
    highp float share = radius * radius / max(dot(point, point), 1e-30);
    return radius * inversesqrt(max(1.0 - share, 0.2));
#endif
}

// `at` counts pixels of the host's own picture, `pixel` is one of this one in uv.
March marchFrom(highp vec2 uv, highp vec2 at, highp vec2 pixel, highp vec3 point, highp vec3 normal)
{
    March march;
    march.normal = normal;
#if CAMERA_ORTHOGRAPHIC
    march.to_camera = vec3(0.0, 0.0, 1.0);
#else
    march.to_camera = -normalize(point);
#endif
    highp vec3 to_camera = hostFromPicture(march.to_camera);
    highp vec3 right = normalize(vec3(max(to_camera.z, 1e-6), 0.0, -to_camera.x));
    march.right = pictureFromHost(right);
    march.up = pictureFromHost(cross(to_camera, right));
    march.shown = reachOf(point);
    // Of a radius wider than the screen the screen's share, within which all taps lie.
    highp float lift = bias * radius / max(max(march.shown.x, march.shown.y), 1.0);
    // Of a normal that leans, the light that one side loses the other gains: no lift for what lies away from here.
    march.point = point + normal * max(lift, depthTolerance(point, normal, 0.0));
    march.clip = clipOf(vec4(point, 1.0));
    march.reach = seenReach(point);
    march.uv = uv;
    march.pixel = pixel;
    march.noise = pixelNoise(at);
    return march;
}

// A slice through the hemisphere.
struct Slice {
    highp vec3 along;  // unit, perpendicular to the direction to the camera
    highp vec3 clip;   // x, y and w in clip space of one reach along it
    highp float cos_n;  // cosine of the angle between the view ray and the normal's projection onto the slice
    highp float sin_n;  // its sine
    highp float projected_length;  // of the unit normal, projected onto the slice
};

// Slices lie evenly over half a turn about the view ray, not on the screen: towards the edge of a wide view
// the two differ by a third. In an empty room seen at 60 degrees this and taps in perspective bring the rmse from 0.019
// down to 0.002.
// [Jimenez et al. 2016: lines 5 to 15 of algorithm 1, which turns about the view axis]
Slice sliceOf(March march, int index)
{
    highp float angle = kPi * (float(index) + march.noise.x) / float(SLICES);
    highp vec3 along = cos(angle) * march.right + sin(angle) * march.up;
    highp vec2 projected = vec2(dot(march.normal, march.to_camera), dot(march.normal, along));
    highp float size = length(projected);
    Slice slice = Slice(along, clipOf(vec4(along * march.reach, 0.0)), 1.0, 0.0, 1e-3);
    if (size > 1e-3) {
        slice.cos_n = projected.x / size;
        slice.sin_n = projected.y / size;
        slice.projected_length = size;
    }
    return slice;
}

// On the surface, away from the point; perpendicular to the normal within the slice.
highp vec3 outward(March march, Slice slice, highp float sign)
{
    return sign * (slice.along * slice.cos_n - march.to_camera * slice.sin_n);
}

// How far up on the side an offset from the point leads.
highp float liftOf(March march, Side side, highp vec3 outwards, highp vec3 offset)
{
    highp float rise = dot(offset, march.normal) * inversesqrt(max(dot(offset, offset), 1e-30));
    return liftOf(side, rise, dot(offset, outwards) >= 0.0);
}

// Cosine of the angle of an offset from the point.
highp float cosineOf(March march, Side side, highp vec3 outwards, highp vec3 offset)
{
    return cosineOfLift(side, liftOf(march, side, outwards, offset));
}

highp float radiusFade(March march)
{
    return radiusFade(march.shown, march.pixel);
}

// Whether the surface at the uv of a tap is known, and its offset from the point. `at` becomes the uv of what
// the tap sees.
bool offsetAt(March march, inout highp vec2 at, out highp vec3 offset)
{
    highp vec3 seen;
    bool known = isCaptured(at) && samplePosition(march.uv, at, seen);
    offset = seen - march.point;
    return known;
}

// Where a side leaves what the screen and its guard band show, in reaches: the captured volume in clip space is |x| and
// |y| < GUARD_BAND w, and up to a pixel more, which is not used. `room` is how far the point lies within its four
// planes, `used` what one reach takes of that.
highp float edgeOf(March march, Slice slice, highp float sign)
{
    highp vec3 way = slice.clip * sign;
    highp vec4 room = GUARD_BAND * march.clip.z + vec4(-march.clip.xy, march.clip.xy);
    highp vec4 used = vec4(way.xy, -way.xy) - GUARD_BAND * way.z;
    highp vec4 edges = room / max(used, 1e-30);
    return min(min(edges.x, edges.y), min(edges.z, edges.w));
}

// From tap to tap of a side, in reaches: evenly from the pixel to somewhat beyond the radius, so that the surface is
// seen to leave it, and at most up to the edge. Ours: of four steps the last lies at 0.9 to 1.2 radii. rmse of gtao in
// the room and on the spheres: 0.0466 and 0.0307, with 0.3 in place of 0.6 0.0465 and 0.0309, with 0.9 0.0486 and
// 0.0321.
highp float strideOf(highp float edge)
{
    return min(1.0 / (float(STEPS) - 0.6), edge / float(STEPS));
}

// Where tap `i` of a side lies. A tap is at least a pixel away; behind the camera it is nowhere.
highp vec2 tapAt(March march, Slice slice, highp float sign, highp float stride, int i)
{
    const highp float nowhere = -9.0;
    highp vec3 clip = march.clip + slice.clip * (sign * max(float(i) + march.noise.y, 0.01) * stride);
    if (clip.z <= 0.0) return vec2(nowhere);
    highp vec2 offset = clip.xy / clip.z * 0.5 + 0.5 - march.uv;
    return march.uv + offset / min(length(offset / march.pixel), 1.0);
}

// How much of the hidden space between two neighbouring taps counts as filled: the wider the gap, the likelier it is
// open. `gap` is in units of one that is filled by half. Ours. Where each pixel takes it as all filled or all open, by
// its noise, walls keep blotches that no filter of 4x4 pixels takes out; the mean rmse of gtao in six scenes is 1.5 %
// larger, of bitmask 4 %.
highp float filledShare(highp float gap)
{
    return 1.0 / (1.0 + gap * gap);
}

// What of a step in depth between two taps is not one slope with the step before it: 0 on a plane, however steep. Ours:
// rmse of gtao in the room 0.0466, with the step as it is 0.0473, and of bitmask 0.0423 and 0.0426.
highp float unevenStep(highp float step_here, highp float step_before)
{
    highp float uneven = step_here - step_before;
    return abs(uneven) < abs(step_here) ? uneven : step_here;
}

// Where a way from a place within the radius leaves it: t of |from + t way| = radius.
highp float leavesAt(highp vec3 from, highp vec3 way)
{
    highp float a = dot(way, way);
    highp float b = dot(from, way);
    highp float c = dot(from, from) - radius * radius;
    return (sqrt(max(b * b - a * c, 0.0)) - b) / max(a, 1e-30);
}

// How much of the way from a place within the radius to one outside lies within.
highp float shareWithin(highp vec3 from, highp vec3 to)
{
    return clamp(leavesAt(from, to - from), 0.0, 1.0);
}

// Where the surface last seen on a side leaves the radius, if it goes on beyond the screen's edge in the direction of
// the last two taps: `way` is from one to the other, 0 where they lie on two surfaces.
highp vec3 goneOn(highp vec3 seen, highp vec3 way)
{
    return seen + way * max(leavesAt(seen, way), 0.0);
}
