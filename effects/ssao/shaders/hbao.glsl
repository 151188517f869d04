// SPDX-License-Identifier: MIT
// The occlusion of a point by the horizons about it.
//
// Each side of a slice is marched outwards. Where a tap rises above all before it, the part of the side
// between the two horizons is blocked, the less the farther the tap lies.
//
//   LIGHT           uniform or cosine: how much light an angle over the surface brings
//   THIN_OCCLUDERS  skip: distance counts in space, so that light passes behind what stands far in front;
//                   count: distance counts across the view ray, as if everything went on behind
//
// [Bavoil, Sainz 2008] - the integral of sin h - sin t, of elevations over the screen; here angles count from the
// camera, so that sines are cosines. [SCS 2020] - skip or count.

#undef SHADING_NORMALS
#define SHADING_NORMALS 0  // the authors have one normal
#include "common/angles.glsl"
#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

uniform mediump float angle_bias;
uniform mediump float falloff;

// How much what lies at an offset counts, 0..1. 1 - d^2 / R^2 with falloff 1, as in NVIDIA's sample gl_ssao.
mediump float weightOf(mediump vec3 camera, mediump vec3 offset)
{
#if THIN_OCCLUDERS == THIN_OCCLUDERS_COUNT
    mediump float nearer = dot(offset, camera);
    offset -= camera * nearer;
    if (nearer < -0.7 * kFar) return 0.0;  // the background
#endif
    mediump float share = dot(offset, offset);
    return share < 1.0 ? 1.0 - falloff * share : 0.0;
}

// How high over a surface something stands within a slice: a lift is 0 along the surface and 1 along the normal, in
// between the sine of the angle over the surface; beyond the normal, towards the camera, it goes on to 2 less that sine.
// From the components of a unit direction along the normal and towards the camera.
mediump float liftOf(Side side, mediump float height, mediump float towards)
{
    mediump float up = clamp(height, 0.0, 1.0);
    if (side.sin_n > 0.0 && towards > side.cos_n) up = up > side.cos_n ? 2.0 - up : 0.0;
    return up;
}

// The light of a side between its surface and a lift. [Jimenez et al. 2016, algorithm 1] - of a cosine-weighted
// hemisphere
mediump float lightUpToLift(Side side, mediump float lift)
{
    mediump float up = min(lift, 2.0 - lift);
    mediump float level = sqrt(max(1.0 - up * up, 0.0));
#if LIGHT == LIGHT_COSINE
    mediump float across = 1.5707963 - angleOf(up) - up * level;
    return 0.5 * (side.cos_n * up * up + side.sin_n * (lift > 1.0 ? 3.1415927 - across : across));
#else
    return side.cos_n * up + side.sin_n * (lift > 1.0 ? 1.0 + level : 1.0 - level);
#endif
}

// The light of a side between its surface and where an offset leads.
mediump float lightUpTo(March march, mediump vec3 camera, Side side, mediump vec3 offset)
{
    mediump float inverse = inversesqrt(max(dot(offset, offset), 1e-5));
    mediump float height = dot(offset, march.normal) * inverse / side.projected_length;
    return lightUpToLift(side, liftOf(side, height, dot(offset, camera) * inverse));
}

// The blocked light of one side. Off the screen the surface last seen goes on until it leaves the radius, with the mean
// of the weights of both its ends.
mediump float blockedOn(March march, Side side, mediump float least_lift, int steps)
{
    // The light below the horizon: at first that below the bias, of a side that ends before, all.
    mediump float below = lightUpToLift(side, side.sin_n > 0.0 ? least_lift : min(least_lift, side.cos_n));
    mediump float blocked = 0.0;
    mediump float weight = 0.0;
    mediump vec3 before = vec3(0.0);
    mediump vec3 way = vec3(0.0);
    mediump vec3 camera = toCamera(march.pixel);
    highp vec2 at = side.first;
    for (int i = 0; i < steps; ++i) {
        mediump vec3 offset = offsetAt(march, texelOf(march, at - march.pixel));
        at += side.step;
        weight = weightOf(camera, offset);
        mediump float higher = max(lightUpTo(march, camera, side, offset) - below, 0.0);
        blocked += weight * higher;
        below += weight > 0.0 ? higher : 0.0;
        way = dot(before, before) < 1.0 ? offset - before : vec3(0.0);
        before = offset;
        if (i + 1 >= steps) break;
    }
    mediump float near = dot(before, before);
    if (side.cut && near < 1.0) {
        mediump float a = max(dot(way, way), 1e-4);
        mediump float b = dot(before, way);
        mediump float leaves = (sqrt(max(b * b - a * (near - 1.0), 0.0)) - b) / a;
        mediump vec3 end = before + way * max(leaves, 0.0);
        blocked += 0.5 * (weight + 1.0 - falloff) * max(lightUpTo(march, camera, side, end) - below, 0.0);
    }
    return blocked;
}

// Interface `estimator`: 1 open .. 0 blocked, of what marchFrom or marchOf has found; 1 where that is not `known`.
mediump float visibilityFrom(March march, bool known)
{
    // No constants: written out, the loops would take more registers than a phone has.
    int sides = known ? 2 * kSlices : 0;
    int steps = known ? STEPS : 0;
    mediump float least_lift = sin(radians(angle_bias));
    mediump float blocked = 0.0;
    mediump float whole = 0.0;
    for (int i = 0; i < sides; ++i) {
        Side side = sideOf(march, i);
#if LIGHT == LIGHT_COSINE
        blocked += side.projected_length * blockedOn(march, side, least_lift, steps);
        whole += side.projected_length * lightUpToLift(side, side.sin_n > 0.0 ? 2.0 - side.cos_n : side.cos_n);
#else
        blocked += blockedOn(march, side, least_lift, steps);
        whole += 1.0;  // of every two sides 2
#endif
        if (i + 1 >= sides) break;
    }
    return visibilityOf(radiusFade(march) * blocked / max(whole, 1e-3));
}
