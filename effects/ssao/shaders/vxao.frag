#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion from cones through voxels: the whole scene occludes, seen or not.
//
//   surface  interface: point and normals in view space
//   voxels   interface: how much of a place surfaces fill, as seen along each edge of a box
//   ao       visibility, 1 open .. 0 blocked; 1 in the background and beyond the boxes
//
// [Crassin et al. 2011 - cones through mips of voxels with an opacity by direction]
// [NVIDIA 2016 - ambient occlusion by them, in boxes about the camera, each twice as large as the one before]
// Ours: what the surface itself fills is taken off; a cone's voxels are no larger than that leaves room for.
precision highp float;

#include "common/pixel_noise.glsl"
#include "common/tangent_frame.glsl"
#include "common/view_space.glsl"
#include <surface>
#include <voxels>
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/shaders/shading_normals.glsl"

in vec2 uv;
layout(location = 0) out float ao;

const vec2 kFirst = vec2(0.7, 1.3);  // voxels along a cone to its first sample, from pixel to pixel
const float kStride = 1.5;    // voxels from sample to sample
const float kSpread = 0.12;   // diameter of the samples over that of the cone, whose way varies from pixel to pixel
const float kLeastOpen = 0.02;

// What a cone about the unit vector `way` leaves open, which stands on the plane by the cosine `height`, and is one of
// CONES of equal weight by the cosine `facing`.
float coneOpen(Voxels voxels, vec3 place, vec3 own, vec3 way, float height, float facing, float first)
{
    vec3 step_in_box = mat3(boxFromView(voxels.box)) * way;
    vec3 along = abs(normalize(step_in_box));
    // A cell of 1 / CONES of all weight is the solid angle pi / (CONES facing), of that of a square of this width.
    float spread = kSpread * sqrt(3.14159265 / (float(CONES) * max(facing, 0.1)));
    float largest = min(spread, height / kApart);
    float open = 1.0;
    float before = 0.0;
    float stride;
    for (float at = first * voxels.size; at < radius; at += stride) {
        float level = floor(log2(max(at * largest / voxels.size, 1.0)) + 0.01);
        float width = voxels.size * exp2(level);
        stride = kStride * width;
        vec3 filled = fillingAt(voxels, place + at * step_in_box, level);
        filled = withoutOwn(filled, own, width / voxels.size, at * height / width);
        // As many voxels behind each other as a step has; of the last one, what lies within the radius.
        float depth = min(stride, radius - at + 0.5 * stride) / voxels.size;
        float here = min(dot(filled, along) * depth, 1.0);
        // What two samples in a row meet is most often one wall, whose shares add up.
        open *= max(1.0 - here - before, 0.0) / max(1.0 - before, 0.01);
        before = here;
        if (open < kLeastOpen) return 0.0;
    }
    return open;
}

void main()
{
    vec3 point;
    ao = 1.0;
    if (!viewPosition(uv, point)) return;
    vec3 normal = normalAt(uv);
    vec3 plane = normal;
#if SHADING_NORMALS
    plane = planeAt(uv, point, normal);
#endif
    vec2 noise = pixelNoise(floor(gl_FragCoord.xy));
    Voxels voxels;
    if (!findVoxels(point, noise.x, voxels)) return;
    float turn = 6.2831853 * noise.x;
    mat3 frame = rotatedFrame(normal, vec2(cos(turn), sin(turn)));
    vec3 own = ownFilling(voxels, plane);
    vec3 place = (boxFromView(voxels.box) * vec4(point, 1.0)).xyz;
    float open = 0.0;
    float known = 0.0;  // the light over the plane: below it is none
    for (int i = 0; i < CONES; ++i) {
        // Equal shares of the cosine, by the golden angle about the normal.
        float share = (float(i) + noise.y) / float(CONES);
        float angle = 2.3999632 * float(i);
        float facing = sqrt(1.0 - share);
        vec3 way = frame * vec3(sqrt(share) * vec2(cos(angle), sin(angle)), facing);
        float height = dot(way, plane);
        if (height <= 0.0) continue;
        known += 1.0;
        open += coneOpen(voxels, place, own, way, height, facing, mix(kFirst.x, kFirst.y, noise.y));
    }
    ao = visibilityOf(1.0 - open / max(known, 1.0));
}
