// SPDX-License-Identifier: MIT
// Ambient occlusion from the horizons of slices through the hemisphere, cosine-weighted.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   bent_normal                  with BENT_NORMALS: mean open direction, view space, stored as n * 0.5 + 0.5
//
// Everything below the highest tap of a side counts as blocked, but less of what stands farther in front of the surface
// beside it than it is thick, behind which light passes. A tap beyond the radius does not count; where the surface
// leaves the radius between two taps, the place where it does is interpolated, without which few taps see too low a
// horizon. Off the screen the surface last seen goes on. [Jimenez et al. 2016] - algorithm 1; the bent normal is
// algorithm 2. They fade taps towards the radius; the interpolation and the thickness are ours.

#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

uniform mediump float max_gap;
uniform mediump float thickness;

#ifdef BENT_NORMALS
layout(location = 1) out vec4 bent_normal;
#endif

// Cosine of the angle from the plane up to the horizon of one side. [Jimenez et al. 2016: lines 17 to 26 of algorithm 1]
mediump float horizonOf(March march, Side side, int steps)
{
    mediump float horizon = 1.0;
    mediump vec2 before = vec2(0.0);  // what the tap before saw
    mediump vec2 way = vec2(0.0);     // from there
    mediump float near = 0.0;         // its distance, squared
    mediump float step_before = 0.0;
    mediump float filled = 1.0;
    mediump float out_by = 0.0;
    highp float place = 0.0;
    for (int i = 0; i < steps; ++i) {
        mediump float apart = -place;
        place = placeOf(march, side, i);
        apart = max(apart + place, 1e-4);  // 0 where the radius has fewer pixels than steps
        mediump vec2 at = withinSlice(march, side, offsetAt(march, texelOf(march, place * float(STEPS) * side.step)));
        way = at - before;
        mediump float step_here = dot(way, side.towards);
        mediump float uneven = unevenStep(step_here, step_before);
        filled = filledShare(uneven / (apart * max_gap));
        out_by = max(out_by + uneven, 0.0);
        mediump float joined = filledShare(max(out_by - thickness, 0.0) / apart);
        mediump float far = dot(at, at);
        bool inside = far < 1.0;
        // Of a surface that goes on beyond the radius, where it leaves it.
        mediump vec2 seen = inside ? at * inversesqrt(max(far, 1e-5)) : before + min(leaving(before, way), 1.0) * way;
        mediump float lower = isOver(side, seen) ? max(horizon - seen.x, 0.0) : 0.0;
        horizon -= inside ? joined * lower : near < 1.0 ? filled * filled * lower : 0.0;
        before = at;
        near = far;
        step_before = step_here;
        if (i + 1 >= steps) break;
    }
    // Off the screen the surface last seen goes on until it leaves the radius.
    if (side.cut && near < 1.0 && filled >= 0.5 && before.y > 0.0) {
        mediump vec2 end = before + leaving(before, way) * way;
        if (isOver(side, end)) horizon = min(horizon, end.x);
    }
    return horizon;
}

#ifdef BENT_NORMALS
// The light's direction from the camera down to a horizon, cosine and sine over the normal's level; not normalised:
// towards the camera, and along the side. The paper's algorithm 2, one side of it, here as powers of sine and cosine of
// the angle from the camera.
mediump vec2 openDirection(Side side, mediump vec2 horizon)
{
    mediump float c = side.cos_n * horizon.y - side.sin_n * horizon.x;
    mediump float s = sqrt(max(1.0 - c * c, 0.0));
    mediump float c3 = c * c * c;
    mediump float s3 = s * s * s;
    return vec2(side.cos_n * (1.0 - c3) + side.sin_n * s3,
                side.cos_n * s3 + side.sin_n * (2.0 - 3.0 * c + c3)) / 3.0;
}
#endif

// Interface `estimator`: 1 open .. 0 blocked, of what marchFrom or marchOf has found; 1 where that is not `known`.
mediump float visibilityFrom(March march, bool known)
{
#ifndef BENT_NORMALS
    known = known && radiusFade(march) > 0.0;
#endif
    // No constants: written out, the loops would take more registers than a phone has.
    int sides = known ? 2 * kSlices : 0;
    int steps = known ? STEPS : 0;
    mediump float blocked = 0.0;
    mediump float whole = 0.0;
#ifdef BENT_NORMALS
    mediump vec3 bent = vec3(0.0);
#endif
    for (int i = 0; i < sides; ++i) {
        Side side = sideOf(march, i);
        mediump float level = horizonOf(march, side, steps);
        mediump vec2 horizon = overLevel(side, vec2(level, sqrt(max(1.0 - level * level, 0.0))));
        if (horizon.y < 0.0) horizon = vec2(1.0, 0.0);
        mediump float below = lightUpTo(side.cos_n, side.sin_n, horizon.x);
        blocked += side.projected_length * clamp(below - side.below, 0.0, side.whole);
        whole += side.projected_length * side.whole;
#ifdef BENT_NORMALS
        mediump vec2 direction = openDirection(side, horizon);
        bent += side.projected_length * (toCamera(march.pixel) * direction.x + side.along * direction.y);
#endif
        if (i + 1 >= sides) break;
    }
#ifdef BENT_NORMALS
    bent_normal = vec4(0.5, 0.5, 1.0, 0.0);
    if (sides > 0) {
        bent = mix(march.normal * 1e-3, bent, radiusFade(march));
        bent_normal = vec4(normalize(bent + march.normal * 1e-3) * 0.5 + 0.5, 1.0);
    }
#endif
    return visibilityOf(radiusFade(march) * blocked / max(whole, 1e-3));
}
