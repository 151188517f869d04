#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion from bit masks over slices through the hemisphere: each side of a slice has 31
// sectors of equal light, and each tap blocks the sectors between its front and its back, so that light
// passes behind thin objects.
//
//   surface            interface: point and normal in view space
//   depth_back         with BACK_FACES: the first back faces, which end what the surface begins
//   depth_second       with SECOND_LAYER: the first front faces behind those
//   depth_second_back  with SECOND_LAYER: the back faces that end them
//   ao                 visibility, 1 open .. 0 blocked; 1 in the background
//
// [Therrien, Levesque, Gilet 2023, "Screen Space Indirect Lighting with Visibility Bitmask"] - the sectors; theirs are
// of equal angle. Slices are those of ssao/shaders/slice.glsl. That taps join, and that each is clipped to the radius,
// is ours. Off the screen the surface last seen goes on. Figures are rmse in the room and on the spheres, 480x270,
// radius 1; docs/methods/bitmask.md says how to measure.
precision highp float;  // positions and depths; mediump bands
precision highp int;    // all 32 bits of a mask: mediump has 16

#include <surface>
#include "geometry/shaders/depth_point.glsl"
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

uniform float thickness;
uniform float max_gap;

#if BACK_FACES
uniform highp sampler2D depth_back;
#endif
#if SECOND_LAYER
uniform highp sampler2D depth_second;
uniform highp sampler2D depth_second_back;
#endif

uniform vec2 viewport_size;

in vec2 uv;
layout(location = 0) out float ao;

// What a side's last tap has seen.
struct Trail {
    vec3 offset;   // of its front from the point
    vec3 way;      // to there from the tap before; 0 where they do not join
    float sector;  // 0..kSectors, of where its front ends within the radius
    float front;   // how far behind the point, along the view, it begins
    float back;    // and ends
    float step;    // from the front of the tap before
    bool inside;   // whether its front is within the radius
};

// Of a side. One less than an int has bits, so that the bit beyond the last is one too.
const float kSectors = 31.0;

// How deep a sheet, whose back is its front, counts in radii: less parts steep sheets between taps, more closes what is
// open behind leaves. rmse of `high` in a courtyard of open shells and among leaves: 0.037 and 0.129, with 0.1 0.070
// and 0.145, with 0.2 0.042 and 0.127, with 0.3 0.035 and 0.134.
const float kSheet = 0.25;

// Both ends are rounded: 0.0423 and 0.0242. Rounded down and up, about as in the authors' code, 0.0476 and 0.0303.
uint maskOf(float first, float last)
{
    return (1u << uint(max(first, last) + 0.5)) - (1u << uint(min(first, last) + 0.5));
}

// [Anderson 2005, "Bit Twiddling Hacks" - counting bits set, in parallel]
float countOf(uint mask)
{
    uint pairs = mask - ((mask >> 1u) & 0x55555555u);
    uint fours = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return float((((fours + (fours >> 4u)) & 0x0f0f0f0fu) * 0x01010101u) >> 24u);
}

float sectorOf(March march, Side side, vec3 outwards, vec3 offset)
{
    return kSectors * cosineArcIntegral(side, cosineOf(march, side, outwards, offset)) / max(side.whole, 1e-6);
}

// What `max_gap` counts as where backs are known: thicknesses then are those of the scene, most of them less than
// `thickness`, and of two layers the second shows what gaps would have to stand for.
#if SECOND_LAYER
const float kGap = 8.0 / 6.0;
#elif BACK_FACES
const float kGap = 5.0;
#else
const float kGap = 1.0;
#endif

// How much of what lies between two neighbouring taps is filled: half of a gap in depth as large as the nearer of them
// is deep, times `max_gap` and the spacing of the taps, or as the radius.
float filledBetween(Trail trail, float front, float deep)
{
    float share = kGap * max_gap / float(STEPS);
    float thick = trail.back - trail.front;
    float uneven = unevenStep(front - trail.front, trail.step);
    float behind = (uneven - thick) / max(min(share * thick, radius), 1e-30);
    float before = (-uneven - deep) / max(min(share * deep, radius), 1e-30);
    return trail.inside ? filledShare(max(max(behind, before), 0.0)) : 0.0;
}

// The sectors blocked by something whose front is at `offset` and which is `deep` along the ray `away`,
// as far as it lies within the radius; and by the surface that joins it to the tap before, without which
// few taps would miss most of what blocks.
uint blockedBy(March march, Side side, vec3 outwards, vec3 offset, vec3 away, float deep, inout Trail trail)
{
    float front = -dot(offset, march.to_camera);
    float filled = filledBetween(trail, front, deep);

    // The ray is within the radius from -along - root to root - along: |offset + s away| = radius, solved for s.
    float along = dot(offset, away);
    float reached = length(offset);
    float square = along * along + (radius - reached) * (radius + reached);
    float root = sqrt(max(square, 0.0));
    float first = max(-along - root, 0.0);
    float last = min(deep, root - along);
    bool inside = reached < radius;
    bool within = square > 0.0 && first <= last;
    // Of a front beyond the radius, where what joins it leaves the radius.
    vec3 begin = offset + away * first;
    if (!inside && filled > 0.0) begin = mix(trail.offset, offset, shareWithin(trail.offset, offset));
    uint blocked = 0u;
    float sector = kSectors;
    if (within || filled > 0.0) {
        sector = sectorOf(march, side, outwards, begin);
        float part = 0.5 * filled * (trail.sector - sector);  // from either end
        if (within) blocked = maskOf(sector, sectorOf(march, side, outwards, offset + away * last));
        blocked |= maskOf(sector, sector + part) | maskOf(trail.sector - part, trail.sector);
    }
    vec3 way = filled > 0.5 ? offset - trail.offset : vec3(0.0);
    trail = Trail(offset, way, sector, front, front + deep, front - trail.front, inside);
    return blocked;
}

// Away from the camera, at an offset from the point.
vec3 awayAt(March march, vec3 offset)
{
#if CAMERA_ORTHOGRAPHIC
    return vec3(0.0, 0.0, -1.0);
#else
    return normalize(march.point + offset);
#endif
}

#if BACK_FACES
// Thickness of the object whose front is at `front`: up to its back face, that of a sheet where the back is the front,
// or `thickness` where none was drawn.
float depthOf(highp sampler2D backs, March march, vec2 at, vec3 front)
{
    vec3 back;
    bool closed = pointIn(backs, at, back);
    float deep = length(back - march.point - front);
    if (closed && back.z < march.point.z + front.z) return deep;
#if SCENE_SHEETS
    if (closed) return kSheet * radius;
#endif
    return thickness * radius;
}
#endif

uint blockedOn(March march, Slice slice, Side side, float sign)
{
    vec3 outwards = outward(march, slice, sign);
    float edge = edgeOf(march, slice, sign);
    float stride = strideOf(edge);
    uint blocked = 0u;
    Trail trail = Trail(vec3(0.0), vec3(0.0), kSectors, 0.0, thickness * radius, 0.0, true);
#if SECOND_LAYER
    Trail second = Trail(vec3(0.0), vec3(0.0), kSectors, 0.0, 0.0, 0.0, false);
#endif
    for (int i = 0; i < STEPS; ++i) {
        vec2 at = tapAt(march, slice, sign, stride, i);
        vec3 offset;
        if (!offsetAt(march, at, offset)) {
            trail.inside = false;
            continue;
        }
        vec3 away = awayAt(march, offset);
        float deep = thickness * radius;
#if BACK_FACES
        deep = depthOf(depth_back, march, at, offset);
#endif
        blocked |= blockedBy(march, side, outwards, offset, away, deep, trail);
#if SECOND_LAYER
        vec3 behind;
        if (!pointIn(depth_second, at, behind)) {
            second.inside = false;
            continue;
        }
        behind -= march.point;
        deep = depthOf(depth_second_back, march, at, behind);
        blocked |= blockedBy(march, side, outwards, behind, away, deep, second);
#endif
    }
    if (edge < 1.0 && trail.inside) {
        vec3 end = goneOn(trail.offset, trail.way);
        blocked |= maskOf(sectorOf(march, side, outwards, end), trail.sector);
    }
    return blocked;
}

void main()
{
    vec3 point;
    if (!viewPosition(uv, point)) {
        ao = 1.0;
        return;
    }
    vec2 at = hostPixel(gl_FragCoord.xy, viewport_size);
    March march = marchFrom(uv, at, vec2(dFdx(uv.x), dFdy(uv.y)), point, normalAt(uv));
    float blocked = 0.0;
    float whole = 0.0;
    for (int i = 0; i < SLICES; ++i) {
        Slice slice = sliceOf(march, i);
        float weight = slice.projected_length;
        for (float sign = -1.0; sign < 2.0; sign += 2.0) {
            Side side = sideOf(slice.cos_n, slice.sin_n * sign, slice.projected_length);
            float share = countOf(blockedOn(march, slice, side, sign)) / kSectors;
            blocked += weight * side.whole * share;
            whole += weight * side.whole;
        }
    }
    ao = visibilityOf(radiusFade(march) * blocked / max(whole, 1e-6));
}
