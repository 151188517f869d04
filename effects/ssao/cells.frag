#version 300 es
// SPDX-License-Identifier: MIT
// Fits a plane to each cell of the picture.
//
//   surface        interface: point in view space
//   viewport_size  cells, which span the view and its guard band
//   CELL_SIZE      pixels of the view along a side of a cell
//   cells          a Cell each
precision highp float;
precision highp int;

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "ssao/cells.glsl"

uniform vec2 viewport_size;

layout(location = 0) out vec4 cells;

const int kSteps = int(ceil(float(CELL_SIZE) * GUARD));

// Ray and nearness of what is seen at uv; false in the background. The ray is that of the texel, which `uv` may
// be half of off.
bool seenAt(vec2 at, out vec3 seen)
{
    vec3 point;
    bool known = pointAt(at, point);
    seen = vec3(rayOf(point), nearnessOf(point.z));
    return known;
}

void main()
{
    vec2 cell = floor(gl_FragCoord.xy);
    // From edge to edge, so that what lies on an edge belongs to both cells.
    vec2 first = uvInGrid(cell, viewport_size);
    vec2 last = uvInGrid(cell + 1.0, viewport_size);
    vec2 pitch = (last - first) / float(kSteps);
    vec3 low_left, low_right, high_left, high_right;
    seenAt(first, low_left);
    seenAt(vec2(last.x, first.y), low_right);
    seenAt(vec2(first.x, last.y), high_left);
    seenAt(last, high_right);
    vec3 across = 0.5 * (low_right - low_left + high_right - high_left);
    vec3 along = 0.5 * (high_left - low_left + high_right - low_right);
    vec2 apart = vec2(across.x, along.y);
    bool spans = apart.x != 0.0 && apart.y != 0.0;  // not of one texel
    vec2 slope = spans ? vec2(across.z, along.z) / apart : vec2(0.0);
    vec3 mean = 0.25 * (low_left + low_right + high_left + high_right);
    vec2 middle_ray = rayAt(0.5 * (first + last));
    float middle = mean.z + dot(slope, middle_ray - mean.xy);

    float off = 0.0;
    float least = 1e30;
    float most = -1e30;
    int drawn = 0;
    for (int j = 0; j <= kSteps; ++j) {
        for (int i = 0; i <= kSteps; ++i) {
            vec3 seen;
            bool known = seenAt(first + vec2(float(i), float(j)) * pitch, seen);
            drawn += known ? 1 : 0;
            off = max(off, abs(seen.z - middle - dot(slope, seen.xy - middle_ray)));
            least = known ? min(least, seen.z) : least;
            most = known ? max(most, seen.z) : most;
        }
    }
    vec4 fitted = vec4(middle, slope, off);
    if (drawn < (kSteps + 1) * (kSteps + 1) || off > most - least)  // no plane: all that is between
        fitted = vec4(0.5 * (least + most), 0.0, 0.0, 0.5 * (most - least));
    fitted.w += CELLS_STEP.x + CELLS_STEP.y * (abs(fitted.x) + abs(across.z) + abs(along.z));
    bool told = max(max(abs(fitted.x), fitted.w), max(abs(fitted.y), abs(fitted.z))) < kMixed;
    cells = drawn == 0 ? vec4(0.0, 0.0, 0.0, -1.0) : told ? fitted : vec4(0.0, 0.0, 0.0, kMixed);
}
