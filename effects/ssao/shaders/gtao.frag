#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion from the horizons of slices through the hemisphere, cosine-weighted.
//
//   surface      interface: point and normal in view space
//   ao           visibility, 1 open .. 0 blocked; 1 in the background
//   bent_normal  with BENT_NORMALS: mean open direction, view space, stored as n * 0.5 + 0.5
//
// Everything below the highest tap of a side counts as blocked. A tap beyond the radius does not count;
// where the surface leaves the radius between two taps, the place where it does is interpolated, without
// which few taps see too low a horizon. Off the screen the surface last seen goes on.
// [Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion"] - algorithm 1; the bent normal
// is algorithm 2. They fade taps towards the radius; the interpolation is ours, see ssao/shaders/march.glsl for its
// figures.
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include <surface>
#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

uniform float max_gap;

uniform vec2 viewport_size;

in vec2 uv;
layout(location = 0) out float ao;
#ifdef BENT_NORMALS
layout(location = 1) out vec4 bent_normal;
#endif

// Cosine of the horizon of one side. [Jimenez et al. 2016: lines 17 to 26 of algorithm 1]
float horizonOf(March march, Slice slice, Side side, float sign)
{
    vec3 outwards = outward(march, slice, sign);
    float lift = 0.0;  // of the horizon
    float edge = edgeOf(march, slice, sign);
    float stride = strideOf(edge);
    vec3 before = vec3(0.0);
    vec3 way = vec3(0.0);
    float before_distance = 0.0;
    float before_step = 0.0;
    float widest = max_gap / float(STEPS) * radius;
    for (int i = 0; i < STEPS; ++i) {
        vec2 at = tapAt(march, slice, sign, stride, i);
        vec3 offset;
        if (!offsetAt(march, at, offset)) continue;
        float distance_here = length(offset);
        way = offset - before;
        float step_here = dot(way, march.to_camera);
        float filled = filledShare(unevenStep(step_here, before_step) / widest);
        if (filled < 0.5) way = vec3(0.0);
        if (distance_here < radius) {
            lift = max(lift, liftOf(march, side, outwards, offset));
        } else if (before_distance < radius) {
            vec3 leaves = mix(before, offset, shareWithin(before, offset));
            lift += filled * max(liftOf(march, side, outwards, leaves) - lift, 0.0);
        }
        before = offset;
        before_distance = distance_here;
        before_step = step_here;
    }
    if (edge < 1.0 && before_distance < radius)
        lift = max(lift, liftOf(march, side, outwards, goneOn(before, way)));
    return cosineOfLift(side, lift);
}

void main()
{
    vec3 point;
    if (!viewPosition(uv, point)) {
        ao = 1.0;
#ifdef BENT_NORMALS
        bent_normal = vec4(0.5, 0.5, 1.0, 0.0);
#endif
        return;
    }
    vec2 at = hostPixel(gl_FragCoord.xy, viewport_size);
    March march = marchFrom(uv, at, vec2(dFdx(uv.x), dFdy(uv.y)), point, normalAt(uv));
    float open = 0.0;
    float whole = 0.0;
    vec3 bent = vec3(0.0);
    for (int i = 0; i < SLICES; ++i) {
        Slice slice = sliceOf(march, i);
        float weight = slice.projected_length;
        for (float sign = -1.0; sign < 2.0; sign += 2.0) {
            Side side = sideOf(slice.cos_n, slice.sin_n * sign, slice.projected_length);
            float horizon = horizonOf(march, slice, side, sign);
            open += weight * cosineArcIntegral(side, horizon);
            whole += weight * side.whole;
#ifdef BENT_NORMALS
            vec2 direction = openDirection(side, horizon);
            bent += weight * (march.to_camera * direction.x + slice.along * (sign * direction.y));
#endif
        }
    }
#ifdef BENT_NORMALS
    bent = mix(march.normal * 1e-3, bent, radiusFade(march));
    bent_normal = vec4(normalize(bent + march.normal * 1e-6) * 0.5 + 0.5, 1.0);
#endif
    ao = visibilityOf(radiusFade(march) * (1.0 - open / max(whole, 1e-6)));
}
