#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion from the horizons of slices through the hemisphere, cosine-weighted.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   ao                           visibility, 1 open .. 0 blocked; 1 in the background
//   bent_normal                  with BENT_NORMALS: mean open direction, view space, stored as n * 0.5 + 0.5
//
// Everything below the highest tap of a side counts as blocked. A tap beyond the radius does not count; where the
// surface leaves the radius between two taps, the place where it does is interpolated, without which few taps see too
// low a horizon. Off the screen the surface last seen goes on.
// [Jimenez et al. 2016] - algorithm 1; the bent normal is algorithm 2. They fade taps towards the radius; the
// interpolation is ours.
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

uniform float max_gap;

layout(location = 0) out float ao;
#ifdef BENT_NORMALS
layout(location = 1) out vec4 bent_normal;
#endif

// Lift of the horizon of one side. [Jimenez et al. 2016: lines 17 to 26 of algorithm 1]
mediump float horizonOf(March march, Side side, int steps)
{
    mediump float horizon = side.ground;
    mediump vec3 before = vec3(0.0);  // what the tap before saw
    mediump float near = 0.0;         // its distance, squared
    mediump float step_before = 0.0;
    mediump float gone_on = 0.0;
    mediump float per_gap = float(STEPS) / max_gap;
    mediump float per_height = 1.0 / side.projected_length;
    highp vec2 at = side.first;
    for (int i = 0; i < steps; ++i) {
        mediump vec3 offset = offsetAt(march, texelOf(march, at));
        at += side.step;
        mediump float far = dot(offset, offset);
        mediump vec3 way = offset - before;
        mediump float height = dot(offset, march.normal);
        mediump float rise = dot(way, march.normal);
        mediump float step_here = dot(way, march.to_camera);
        mediump float filled = filledShare(unevenStep(step_here, step_before) * per_gap);
        // Of a surface that goes on beyond the radius, where it leaves it: t of |before + t way| = 1.
        mediump float a = max(dot(way, way), 1e-4);
        mediump float b = dot(before, way);
        mediump float leaves = (sqrt(max(b * b - a * (near - 1.0), 0.0)) - b) / a;
        bool inside = far < 1.0;
        mediump float inverse = inversesqrt(max(far, 1e-5));
        mediump float up = inside ? height * inverse : height + rise * clamp(leaves - 1.0, -1.0, 0.0);
        up = liftOf(up * per_height, dot(offset, march.to_camera) * inverse, side.cos_n, side.sin_n);
        mediump float higher = max(up - horizon, 0.0);
        horizon += inside ? higher : near < 1.0 ? filled * higher : 0.0;
        gone_on = height + (filled < 0.5 ? 0.0 : rise * max(leaves - 1.0, 0.0));
        before = offset;
        near = far;
        step_before = step_here;
    }
    // Off the screen the surface last seen goes on until it leaves the radius.
    if (side.cut && near < 1.0) horizon = max(horizon, min(gone_on * per_height, 1.0));
    return horizon;
}

void main()
{
    March march;
    // No constants: written out, the loops would take more registers than a phone has.
    bool known = marchFrom(gl_FragCoord.xy, march);
    int sides = known ? 2 * SLICES : 0;
    int steps = known ? STEPS : 0;
    mediump float blocked = 0.0;
    mediump float whole = 0.0;
#ifdef BENT_NORMALS
    mediump vec3 bent = vec3(0.0);
#endif
    for (int i = 0; i < sides; ++i) {
        Side side = sideOf(march, i);
        mediump float horizon = horizonOf(march, side, steps);
        blocked += side.projected_length * (lightBelow(horizon, side.cos_n, side.sin_n) - side.below);
        whole += side.projected_length * side.whole;
#ifdef BENT_NORMALS
        mediump vec2 direction = openDirection(horizon, side.cos_n, side.sin_n);
        bent += side.projected_length * (march.to_camera * direction.x + side.along * direction.y);
#endif
    }
#ifdef BENT_NORMALS
    bent_normal = vec4(0.5, 0.5, 1.0, 0.0);
    if (sides > 0) {
        bent = mix(march.normal * 1e-3, bent, radiusFade(march));
        bent_normal = vec4(normalize(bent + march.normal * 1e-3) * 0.5 + 0.5, 1.0);
    }
#endif
    ao = visibilityOf(radiusFade(march) * blocked / max(whole, 1e-3));
}
