#version 300 es
// SPDX-License-Identifier: MIT
// Which pixels an estimator has to look at.
//
//   surface     interface: point in view space; with OPEN_TILES normal too
//   open_cells  with OPEN_TILES: cells about which nothing rises over the surface, and their normals
//   depth       0 in the background, a quarter where nothing can occlude, 1 elsewhere
precision highp float;  // as the surface has it

#ifndef OPEN_TILES
#define OPEN_TILES 0
#endif
#if !OPEN_TILES
#define SURFACE_WITHOUT_NORMAL
#endif
#include <surface>
#if OPEN_TILES
#include "common/guard.glsl"
#include "ssao/open_normal.glsl"

uniform mediump sampler2D open_cells;
#endif

in vec2 uv;

#if OPEN_TILES
bool isOpen()
{
    ivec2 size = textureSize(open_cells, 0);
    ivec2 cell = clamp(ivec2(uvInGuard(uv) * vec2(size)), ivec2(0), size - 1);
    vec4 plane = texelFetch(open_cells, cell, 0);
    if (plane.a < 0.5) return false;
    return distance(normalize(plane.xyz * 2.0 - 1.0), normalAt(uv)) < kSeenTolerance;
}
#endif

void main()
{
    vec3 point;
    bool drawn = pointAt(uv, point);
#if OPEN_TILES
    float occludable = drawn && isOpen() ? 0.25 : 1.0;
#else
    const float occludable = 1.0;
#endif
    gl_FragDepth = drawn ? occludable : 0.0;
}
