// SPDX-License-Identifier: MIT
// Cells: the captured picture in a coarse grid, each with the plane that fits what it shows.
//
// Over the rays of a camera a plane is linear: in view depth with an orthographic one, in its inverse else. That
// number, here `nearness`, grows towards the camera. A ray is told by where it meets the plane at distance 1, or
// by its place across the view.

#include "common/view_space.glsl"

// What a cell holds: nearness at its middle, how it changes over rays, and how far off it lies at most.
struct Cell {
    highp float nearness;
    highp vec2 slope;
    highp float off;  // kMixed where no such plane is known; below 0 in the background
};

const highp float kMixed = 6e4;  // fits a half

highp vec2 rayOf(highp vec3 point)
{
#if CAMERA_ORTHOGRAPHIC
    return point.xy;
#else
    return point.xy / -point.z;
#endif
}

highp vec2 rayAt(highp vec2 uv)
{
    return rayOf((view_from_window * vec4(uv, 0.0, 1.0)).xyz);
}

highp float nearnessOf(highp float z)
{
#if CAMERA_ORTHOGRAPHIC
    return z;
#else
    return -1.0 / z;
#endif
}

// The view's uv at a place in the grid, which spans the guard band as well.
highp vec2 uvInGrid(highp vec2 place, highp vec2 size)
{
    return uvFromGuard(place / size);
}
