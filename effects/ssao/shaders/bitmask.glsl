// SPDX-License-Identifier: MIT
// Ambient occlusion from bit masks over slices through the hemisphere: each side of a slice has 31 sectors of equal
// light, and each tap blocks the sectors between its front and its back, so that light passes behind thin objects.
//
//   source_depth, source_normal  as ssao/shaders/march.glsl has them
//   source_layers                with BACK_FACES: what ssao/shaders/layers.frag wrote
//
// [Therrien et al. 2023] - the sectors; theirs are of equal angle. That taps join, and that each is clipped to the
// radius, is ours. Off the screen the surface last seen goes on. Figures are rmse in the room and on the spheres,
// 480x270, radius 1; docs/reference/methods.md says how to measure.

#include "ssao/shaders/march.glsl"
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/bitmask/sectors.glsl"

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

// What a side's last tap has seen.
struct Trail {
    mediump vec2 at;
    mediump float sector;  // of where its front ends within the radius, half of one on: 0.5 and more
    mediump float deep;    // from front to back
    mediump float step;    // in depth, from the front of the tap before
    mediump vec2 way;      // from there, 0 where what lies between is more open than filled
};

#ifdef VOXEL_RAYS
// Gaps of this many voxels and more are not guessed: voxels tell what is in them. From, and altogether.
const mediump vec2 kGuessed = vec2(1.0, 3.0);
#endif

// Of places half a sector on, so that both ends are rounded: 0.0423 and 0.0242. Rounded down and up, about as in the
// authors' code, 0.0476 and 0.0303.
uint maskBetween(mediump float least, mediump float most)
{
    // Written inline, the literal would take the precision of what it is shifted by: 16 bits of the mask.
    highp uint begin = uint(least);
    highp uint end = uint(most);
    return (1u << end) - (1u << begin);
}

// In either order.
uint maskOf(mediump float first, mediump float last)
{
    return maskBetween(min(first, last), max(first, last));
}

// How much of what lies between two neighbouring taps is filled: half of a gap in depth, from the nearer one's back on,
// that is `max_gap` times as large as the taps lie `apart`, where all steps are 1. `step_here` is towards the camera. With
// VOXEL_RAYS, nothing of gaps much larger than a `voxel`.
mediump float filledBetween(Trail trail, mediump float step_here, mediump float deep, mediump float apart,
                            mediump float voxel)
{
    mediump float uneven = unevenStep(step_here, trail.step);
    mediump float gap = max(abs(uneven) - (uneven > 0.0 ? deep : trail.deep), 0.0);
    mediump float filled = clamp(max_gap * apart, 1e-2, 1.0);
    mediump float share = filled * filled / (filled * filled + gap * gap);  // filledShare(gap / filled), by one division
#ifdef VOXEL_RAYS
    share *= 1.0 - smoothstep(kGuessed.x, kGuessed.y, gap / voxel);
#endif
    return share;
}

// Half a sector beyond where `at` lies, of a side whose light is counted in sectors.
mediump float sectorOf(Side side, mediump vec2 at)
{
    return clamp(lightUnder(side, at) - side.below, 0.5, kSectors + 0.5);
}

// The sectors blocked by something whose front is `at` and which is `deep` along its ray `away`, within the radius; and by
// the surface that joins it to the tap before, without which few taps would miss most.
uint blockedBy(Side side, mediump vec2 at, mediump vec2 away, mediump float deep, mediump float apart,
               mediump float voxel, inout Trail trail)
{
    mediump float square = dot(at, at);
    mediump float near = dot(trail.at, trail.at);
    mediump vec2 way = at - trail.at;
    mediump float step_here = dot(way, side.towards);
    mediump float filled = near < 1.0 ? filledBetween(trail, step_here, deep, apart, voxel) : 0.0;

    // The ray is within the radius from -along - root to root - along: |at + s away| = 1, solved for s.
    mediump float along = dot(at, away);
    mediump float within = along * along + 1.0 - square;
    mediump float root = sqrt(max(within, 0.0));
    mediump float first = max(-along - root, 0.0);
    mediump float last = min(deep, root - along);
    bool meets = within > 0.0 && first <= last;
    mediump vec2 begin = at + first * away;
    if (square >= 1.0 && filled > 0.0) begin = trail.at + min(leaving(trail.at, way), 1.0) * way;
    uint blocked = 0u;
    mediump float sector = 0.5;
    if (meets || filled > 0.0) {
        sector = sectorOf(side, begin);
        mediump float part = 0.5 * filled * (trail.sector - sector);  // from either end
        mediump float back = meets ? sectorOf(side, at + last * away) : sector;
        // All of what begins at `sector`, to either side.
        blocked = maskBetween(min(min(sector, sector + part), back), max(max(sector, sector + part), back)) |
                  maskOf(trail.sector - part, trail.sector);
    }
    trail = Trail(at, sector, deep, step_here, filled > 0.5 ? way : vec2(0.0));
    return blocked;
}

#if BACK_FACES
mediump float lengthOf(mediump float stored)
{
    return stored / max(1.0 - stored, 1e-3);
}
#endif

// `blocked` and the sectors blocked by the first things that taps see, or with `second` by those behind them: one march
// each, for both at once take more registers than phones have.
uint blockedOn(March march, Side side, bool second, mediump float voxel, uint blocked)
{
    highp float place = 0.0;
    Trail trail = Trail(vec2(second ? 2.0 : 0.0), 0.5, second ? 0.0 : thickness, 0.0, vec2(0.0));  // 2: nothing near
    for (int i = 0; i < STEPS; ++i) {
        mediump float apart = -place;
        place = placeOf(march, side, i);
        apart += place;
        highp vec2 texel = texelOf(march, place * float(STEPS) * side.step);
        mediump vec2 at = withinSlice(march, side, offsetAt(march, texel));
        mediump vec2 away = normalize(at * march.nearness - side.towards);
        mediump float deep = thickness;
#if BACK_FACES
        mediump vec3 layers = texelFetch(source_layers, ivec2(texel) + march.band, 0).xyz;
        mediump float stored = second ? layers.z : layers.x;
        if (stored < 1.0) deep = lengthOf(stored);
#endif
#if SECOND_LAYER
        if (second) {
            // Farther by what the texture rounds: what goes on behind an edge is not to stand out.
            mediump float behind = lengthOf(layers.y);
            at += away * min(behind + SOURCE_LAYERS_STEP.x * (1.0 + behind) * (1.0 + behind), 40.0);
        }
#endif
        blocked |= blockedBy(side, at, away, deep, apart, voxel, trail);
    }
    // Off the screen the surface last seen goes on until it leaves the radius.
    if (side.cut && !second && dot(trail.at, trail.at) < 1.0)
        blocked |= maskOf(sectorOf(side, trail.at + leaving(trail.at, trail.way) * trail.way), trail.sector);
    return blocked;
}

// Interface `estimator`: 1 open .. 0 blocked, of what marchFrom or marchOf has found; 1 where that is not `known`.
mediump float visibilityFrom(March march, bool known)
{
    known = known && radiusFade(march) > 0.0;
    // Not a constant: written out, sides and layers would take more registers than a phone has.
    int sides = known ? 2 * kSlices : 0;
    int layers = SECOND_LAYER > 0 ? sides : 1;  // 2 or 1, by the break
    mediump float blocked = 0.0;
    mediump float whole = 0.0;
    mediump float voxel = 0.0;
#ifdef VOXEL_RAYS
    Voxelled voxels = voxelled(march);
    voxel = voxels.size;
#endif
    for (int i = 0; i < sides; ++i) {
        Side side = sideOf(march, i);
        mediump float light = side.projected_length * side.whole;
        mediump float sectors_of_light = kSectors / side.whole;
        side.cos_n *= sectors_of_light;
        side.sin_n *= sectors_of_light;
        side.below = side.below * sectors_of_light - 0.5;
        uint mask = 0u;
        for (int layer = 0; layer < layers; ++layer) {
            mask = blockedOn(march, side, layer > 0, voxel, mask);
#if SECOND_LAYER
            if (layer > 0) break;
#endif
        }
        mediump float sectors = countOf(mask);
#ifdef VOXEL_RAYS
        sectors += blockedByVoxels(march, voxels, side, mask, i);
#endif
        blocked += light * sectors / kSectors;
        whole += light;
        if (i + 1 >= sides) break;
    }
    return visibilityOf(radiusFade(march) * blocked / max(whole, 1e-3));
}
