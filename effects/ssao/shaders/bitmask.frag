#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion from bit masks over slices through the hemisphere: each side of a slice has 31
// sectors of equal light, and each tap blocks the sectors between its front and its back, so that light
// passes behind thin objects.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   source_layers                with BACK_FACES: what ssao/shaders/layers.frag wrote
//   ao                           visibility, 1 open .. 0 blocked; 1 in the background
//
// [Therrien et al. 2023] - the sectors; theirs are of equal angle. That taps join, and that each is clipped to the
// radius, is ours. Off the screen the surface last seen goes on. Figures are rmse in the room and on the spheres,
// 480x270, radius 1; docs/reference/methods.md says how to measure.
precision highp float;  // positions and depths; mediump bands
precision highp int;    // all 32 bits of a mask: mediump has 16

#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

// Switches of geometry/back_faces and geometry/second_layer, which a config may lack. The second layer is what lies
// behind the back faces: there is none without them.
#ifndef BACK_FACES
#define BACK_FACES 0
#endif
#if !defined(SECOND_LAYER) || !BACK_FACES
#undef SECOND_LAYER
#define SECOND_LAYER 0
#endif

uniform mediump float thickness;
uniform mediump float max_gap;
#if BACK_FACES
uniform mediump sampler2D source_layers;
#endif

layout(location = 0) out float ao;

// What a side's last tap has seen.
struct Trail {
    mediump vec3 offset;   // of its front from the point
    mediump float sector;  // 0..kSectors, of where its front ends within the radius
    mediump float deep;    // from front to back
    mediump float step;    // in depth, from the front of the tap before
    mediump float gone_on; // height over the surface where it leaves the radius, if it goes on as it came
};

// Of a side. One less than an int has bits, so that the bit beyond the last is one too.
const mediump float kSectors = 31.0;

// Both ends are rounded: 0.0423 and 0.0242. Rounded down and up, about as in the authors' code, 0.0476 and 0.0303.
uint maskOf(mediump float first, mediump float last)
{
    // Written inline, the literal would take the precision of what it is shifted by: 16 bits of the mask.
    highp uint begin = uint(min(first, last) + 0.5);
    highp uint end = uint(max(first, last) + 0.5);
    return (1u << end) - (1u << begin);
}

// [Anderson 2005 - counting bits set, in parallel]
mediump float countOf(uint mask)
{
    uint pairs = mask - ((mask >> 1u) & 0x55555555u);
    uint fours = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return float((((fours + (fours >> 4u)) & 0x0f0f0f0fu) * 0x01010101u) >> 24u);
}

// What `max_gap` counts as where backs are known: thicknesses then are those of the scene, most of them less than
// `thickness`, and of two layers the second shows what gaps would have to stand for.
#if SECOND_LAYER
const mediump float kGap = 8.0 / 6.0;
#elif BACK_FACES
const mediump float kGap = 5.0;
#else
const mediump float kGap = 1.0;
#endif

// A ray of the view through what a tap sees.
struct Ray {
    mediump vec3 away;         // unit, from the camera
    mediump float rise;        // per length, over the surface
    mediump float towards;     // per length, to the camera
};

// How much of what lies between two neighbouring taps is filled: half of a gap in depth as large as the nearer of them
// is deep, times `max_gap` and the spacing of the taps, or as the radius. `step` is towards the camera.
mediump float filledBetween(Trail trail, mediump float step_here, mediump float deep)
{
    mediump float share = kGap * max_gap / float(STEPS);
    mediump float uneven = unevenStep(step_here, trail.step);
    mediump float behind = (-uneven - trail.deep) / max(min(share * trail.deep, 1.0), 1e-3);
    mediump float before = (uneven - deep) / max(min(share * deep, 1.0), 1e-3);
    return dot(trail.offset, trail.offset) < 1.0 ? filledShare(max(max(behind, before), 0.0)) : 0.0;
}

// The sector at a height over the surface; `inverse` is one over the distance, `towards` the distance to the camera.
mediump float sectorOf(Side side, mediump float height, mediump float towards, mediump float inverse)
{
    mediump float lift = liftOf(height * inverse / side.projected_length, towards * inverse, side.cos_n, side.sin_n);
    mediump float light = max(lightBelow(lift, side.cos_n, side.sin_n) - side.below, 0.0);
    return min(kSectors * light / side.whole, kSectors);
}

// The sectors blocked by something whose front is at `offset` and which is `deep` along its ray,
// as far as it lies within the radius; and by the surface that joins it to the tap before, without which
// few taps would miss most of what blocks.
uint blockedBy(March march, Side side, mediump vec3 offset, Ray ray, mediump float deep, inout Trail trail)
{
    mediump float square = dot(offset, offset);
    mediump vec3 way = offset - trail.offset;
    mediump float height = dot(offset, march.normal);
    mediump float rise = dot(way, march.normal);
    mediump float step_here = dot(way, march.to_camera);
    mediump float filled = filledBetween(trail, step_here, deep);

    // The ray is within the radius from -along - root to root - along: |offset + s away| = 1, solved for s.
    mediump float along = dot(offset, ray.away);
    mediump float within = along * along + 1.0 - square;
    mediump float root = sqrt(max(within, 0.0));
    mediump float first = max(-along - root, 0.0);
    mediump float last = min(deep, root - along);
    bool inside = square < 1.0;
    bool meets = within > 0.0 && first <= last;
    // Of a front beyond the radius, where what joins it leaves the radius.
    mediump float a = max(dot(way, way), 1e-4);
    mediump float b = dot(trail.offset, way);
    mediump float leaves = (sqrt(max(b * b - a * (dot(trail.offset, trail.offset) - 1.0), 0.0)) - b) / a;
    mediump float towards = dot(offset, march.to_camera);
    mediump float goes_on = filled > 0.5 ? max(leaves - 1.0, 0.0) : 0.0;
    leaves = clamp(leaves, 0.0, 1.0);
    mediump float begin = height + first * ray.rise;
    mediump float begin_towards = towards + first * ray.towards;
    if (!inside && filled > 0.0) {
        begin = height + (leaves - 1.0) * rise;
        begin_towards = towards + (leaves - 1.0) * step_here;
    }
    uint blocked = 0u;
    mediump float sector = 0.0;
    if (meets || filled > 0.0) {
        sector = sectorOf(side, begin, begin_towards, inside ? inversesqrt(max(square, 1e-5)) : 1.0);
        mediump float part = 0.5 * filled * (trail.sector - sector);  // from either end
        blocked = maskOf(sector, sector + part) | maskOf(trail.sector - part, trail.sector);
    }
    if (meets) {
        mediump float end = square + last * (2.0 * along + last);
        blocked |= maskOf(sector, sectorOf(side, height + last * ray.rise, towards + last * ray.towards,
                                           inversesqrt(max(end, 1e-5))));
    }
    trail = Trail(offset, sector, deep, step_here, height + goes_on * rise);
    return blocked;
}

#if BACK_FACES
mediump float lengthOf(mediump float stored)
{
    return stored / max(1.0 - stored, 1e-3);
}
#endif

// What has been seen where nothing is near.
const Trail kNothing = Trail(vec3(2.0), 0.0, 0.0, 0.0, 0.0);

// The sectors blocked by the first things that taps see, or with `second` by those behind them: one march each, for both
// at once take more registers than phones have.
uint blockedOn(March march, inout Side side, bool second)
{
    uint blocked = 0u;
    Trail trail = kNothing;
    if (!second) trail = Trail(vec3(0.0), 0.0, thickness, 0.0, 0.0);
    for (int i = 0; i < STEPS; ++i) {
        highp vec2 texel = texelOf(march, side.first);
        mediump vec3 offset = offsetAt(march, texel);
        side.first += side.step;
        Ray ray;
        ray.away = awayAt(texel + 0.5);
        ray.rise = dot(ray.away, march.normal);
        ray.towards = dot(ray.away, march.to_camera);
        mediump float deep = thickness;
#if BACK_FACES
        mediump vec3 layers = texelFetch(source_layers, ivec2(texel) + march.band, 0).xyz;
        mediump float stored = second ? layers.z : layers.x;
        if (stored < 1.0) deep = lengthOf(stored);
#endif
#if SECOND_LAYER
        if (second) offset += ray.away * min(lengthOf(layers.y), 40.0);
#endif
        blocked |= blockedBy(march, side, offset, ray, deep, trail);
    }
    side.first -= float(STEPS) * side.step;
    // Off the screen the surface last seen goes on until it leaves the radius, on the side of the normal on which it is.
    // The light below is that of lightBelow to within 5 %: a third sectorOf takes more registers than phones have.
    mediump float near = dot(trail.offset, trail.offset);
    if (side.cut && !second && near < 1.0) {
        mediump float up = clamp(trail.gone_on / side.projected_length, 0.0, 1.0);
        mediump float square = up * up;
        mediump float across = square * up * (0.667 + square * (0.2 + 0.704 * square * square * square));
        if (side.sin_n > 0.0 && dot(trail.offset, march.to_camera) > side.cos_n * sqrt(near)) across = kPi - across;
        mediump float light = 0.5 * (side.cos_n * square + side.sin_n * across) - side.below;
        blocked |= maskOf(clamp(kSectors * light / side.whole, 0.0, kSectors), trail.sector);
    }
    return blocked;
}

void main()
{
    March march;
    // Not a constant: written out, the sides would take more registers than a phone has.
    int sides = marchFrom(gl_FragCoord.xy, march) ? 2 * SLICES : 0;
    int layers = min(sides, 1 + SECOND_LAYER);
    mediump float blocked = 0.0;
    mediump float whole = 0.0;
    for (int i = 0; i < sides; ++i) {
        Side side = sideOf(march, i);
        mediump float light = side.projected_length * side.whole;
        uint mask = 0u;
        for (int layer = 0; layer < layers; ++layer) mask |= blockedOn(march, side, layer > 0);
        blocked += light * countOf(mask) / kSectors;
        whole += light;
    }
    ao = visibilityOf(radiusFade(march) * blocked / max(whole, 1e-3));
}
