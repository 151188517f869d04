// SPDX-License-Identifier: MIT
// The occlusion of a point by the horizons about it, for whoever provides `viewPosition` and `depthTolerance`.
//
// Each side of a slice is marched outwards. Where a tap rises above all before it, the part of the side
// between the two horizons is blocked, the less the farther the tap lies.
//
//   THIN_OCCLUDERS  skip: distance counts in space, so that light passes behind what stands far in front;
//                   count: distance counts across the view ray, as if everything went on behind
//
// [Bavoil, Sainz 2008, "Image-Space Horizon-Based Ambient Occlusion"] - the integral of sin h - sin t, of elevations
// over the screen; here angles count from the camera, so that sines are cosines. [SCS Software] - skip or count.

#include "ssao/shaders/hbao_march.glsl"

uniform highp float angle_bias;
uniform highp float falloff;

// How much a tap counts, 0..1. 1 - d^2 / R^2 with falloff 1, as in NVIDIA's sample gl_ssao.
highp float weightOf(March march, highp vec3 offset)
{
#if THIN_OCCLUDERS == THIN_OCCLUDERS_COUNT
    offset -= march.to_camera * dot(offset, march.to_camera);
#endif
    highp float share = dot(offset, offset) / max(radius * radius, 1e-30);
    return share < 1.0 ? 1.0 - falloff * share : 0.0;
}

// The light of a side up to the cosine `c` of an angle from the direction to the camera.
highp float lightBelow(Side side, highp float c)
{
#if LIGHT == LIGHT_COSINE
    return cosineArcIntegral(side, c);
#else
    return 1.0 - c;
#endif
}

// What is known of a side so far.
struct Blocked {
    highp float horizon;  // its cosine
    highp float open;     // the light below it
    highp float sum;      // the light that is blocked
};

// Raises the horizon to `offset`, with the weight of what lies there.
void raise(March march, Side side, highp vec3 outwards, highp vec3 offset, highp float weight, inout Blocked blocked)
{
    highp float rise = cosineOf(march, side, outwards, offset);
    if (weight <= 0.0 || rise <= blocked.horizon) return;
    highp float still_open = lightBelow(side, rise);
    blocked.sum += weight * (blocked.open - still_open);
    blocked.open = still_open;
    blocked.horizon = rise;
}

// The blocked light of one side. Off the screen the surface last seen goes on, with the mean of the weights of both its
// ends.
highp float blockedOn(March march, Slice slice, Side side, highp float sign)
{
    highp vec3 outwards = outward(march, slice, sign);
    highp float angle = radians(angle_bias);
    // The tangent, raised by the bias, at most up to the camera.
    highp float horizon = side.cos_n < sin(angle) ? 1.0 : side.cos_n * sin(angle) - side.sin_n * cos(angle);
    Blocked blocked = Blocked(horizon, lightBelow(side, horizon), 0.0);
    highp float edge = edgeOf(march, slice, sign);
    highp float stride = strideOf(edge);
    highp vec3 before = vec3(0.0);
    highp vec3 way = vec3(0.0);
    for (int i = 0; i < STEPS; ++i) {
        highp vec3 offset;
        highp vec2 at = tapAt(march, slice, sign, stride, i);
        if (!offsetAt(march, at, offset)) continue;
        raise(march, side, outwards, offset, weightOf(march, offset), blocked);
        way = offset - before;
        before = offset;
    }
    highp float weight = weightOf(march, before);
    if (edge < 1.0 && weight > 0.0) {
        highp vec3 end = goneOn(before, way);
        raise(march, side, outwards, end, 0.5 * (weight + weightOf(march, end)), blocked);
    }
    return blocked.sum;
}

// Of all slices, 0..1.
highp float occlusionOf(March march)
{
    highp float blocked = 0.0;
    highp float whole = 0.0;
    for (int i = 0; i < SLICES; ++i) {
        Slice slice = sliceOf(march, i);
#if LIGHT == LIGHT_COSINE
        highp float weight = slice.projected_length;
#else
        const highp float weight = 1.0;
#endif
        for (highp float sign = -1.0; sign < 2.0; sign += 2.0) {
            Side side = sideOf(slice.cos_n, slice.sin_n * sign, slice.projected_length);
            blocked += weight * blockedOn(march, slice, side, sign);
            whole += weight * lightBelow(side, lastCosine(side));
        }
    }
    return radiusFade(march) * blocked / max(whole, 1e-6);
}
