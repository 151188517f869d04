#version 300 es
// SPDX-License-Identifier: MIT
// Which cells are open: within reach of their taps nothing rises over their plane.
//
//   cells       a Cell each
//   open_cells  normal of the plane, view space, stored as n * 0.5 + 0.5; alpha 1 where open, 0 elsewhere
//   OPEN_SLOPE  how steeply over the surface something may rise and not be told from it
//   STEPS       of estimators that march: their last tap lies beyond the radius
//
// A cell that rises by no more than the bias, and a share of its distance, occludes by less than can be stored.
precision highp float;
precision highp int;

#include "ssao/cells.glsl"
#include "ssao/open_normal.glsl"

uniform highp sampler2D cells;
uniform float radius;
uniform float bias;

layout(location = 0) out vec4 open_cells;

// Cells that are looked at on each side. A radius that reaches farther leaves the cell closed.
const int kFarthest = 12;

#ifndef DEPTH_LEVELS
#define DEPTH_LEVELS 0
#endif

// Farther than the radius: the last tap of a march, and the coarse texel that stands for a tap.
#ifdef STEPS
const float kBeyond = float(STEPS) / (float(STEPS) - 0.6) * (1.0 + 0.15 * float(DEPTH_LEVELS));
#else
const float kBeyond = 1.0 + 0.15 * float(DEPTH_LEVELS);
#endif

Cell cellAt(ivec2 at)
{
    vec4 stored = texelFetch(cells, at, 0);
    return Cell(stored.x, stored.yz, stored.w);
}

// How much more one plane's nearness is than another's over the cell about `ray`, at most.
float mostOver(Cell cell, vec2 ray, vec2 half_size, Cell plane, vec2 plane_ray)
{
    float here = cell.nearness - plane.nearness - dot(plane.slope, ray - plane_ray);
    return here + dot(abs(cell.slope - plane.slope), half_size) + cell.off;
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(cells, 0);
    Cell own = cellAt(here);
    vec2 cell_uv = GUARD / vec2(size);
    vec2 ray = rayAt(uvInGrid(gl_FragCoord.xy, vec2(size)));
    vec2 cell_ray = abs(rayAt(cell_uv) - rayAt(vec2(0.0)));
    vec2 half_size = 0.5 * cell_ray;
    float spread = dot(abs(own.slope), half_size) + abs(own.off);
    open_cells = vec4(0.0);
    if (own.off < 0.0 || own.off >= kMixed) return;

    // The plane's normal, how many scene units a step in nearness is, and how far taps reach over rays.
#if CAMERA_ORTHOGRAPHIC
    vec3 normal = normalize(vec3(-own.slope, 1.0));
    float height_of_step = normal.z;
    float reach = radius * kBeyond;
    float own_off = own.off * height_of_step;
    float per_ray = 1.0;
#else
    vec3 gradient = vec3(own.slope, dot(own.slope, ray) - own.nearness);
    vec3 normal = -normalize(gradient);
    float to_plane = 1.0 / length(gradient);
    float closest = 1.0 / (own.nearness + spread);
    float share = radius * radius / (closest * closest);
    float longest = radius * kBeyond * inversesqrt(max(1.0 - share, 0.2));
    if (own.nearness <= spread || closest <= 1.1 * longest) return;
    float slant = length(vec3(ray, 1.0));
#ifdef STEPS
    float nearer = longest * sqrt(1.0 - 1.0 / (slant * slant));  // taps lie across the view ray
#else
    float nearer = longest;
#endif
    float reach = longest * slant / (closest - nearer);
    float own_off = own.off * to_plane / (own.nearness - spread);
    float per_ray = closest / (slant * slant);
#endif
    ivec2 range = ivec2(ceil(reach / cell_ray));
    if (max(range.x, range.y) > kFarthest) return;

    float lift = bias * radius - own_off;
    for (int j = -range.y; j <= range.y; ++j) {
        for (int i = -range.x; i <= range.x; ++i) {
            ivec2 at = here + ivec2(i, j);
            if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
            Cell other = cellAt(at);
            if (other.off < 0.0) continue;
            if (other.off >= kMixed) return;
            vec2 there = ray + vec2(float(i), float(j)) * cell_ray;
            float over = mostOver(other, there, half_size, own, ray);
            // Nearest and farthest that something in that cell may be from something in this one.
            float apart = max(length(max(abs(vec2(float(i), float(j))) - 1.0, 0.0) * cell_ray) * per_ray, 0.0);
            float slope = OPEN_SLOPE - kNormalTolerance;
            float allowed = lift + slope * (slope > 0.0 ? apart : radius * kBeyond);
#if CAMERA_ORTHOGRAPHIC
            float rises = over * height_of_step;
#else
            float far_end = other.nearness - dot(abs(other.slope), half_size) - other.off;
            float near_end = other.nearness + dot(abs(other.slope), half_size) + other.off;
            float before = closest - 1.0 / max(far_end, 1e-30);
            float behind = 1.0 / near_end - 1.0 / (own.nearness - spread);
            if (max(apart, max(before, behind)) > longest) continue;
            float nearest = far_end;
            float rises = over <= 0.0 ? over * to_plane / (other.nearness + abs(other.off))
                                      : over * to_plane / max(nearest, 1e-30);
#endif
            if (rises > allowed) return;
        }
    }
    open_cells = vec4(normal * 0.5 + 0.5, 1.0);
}
