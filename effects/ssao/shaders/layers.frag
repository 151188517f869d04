#version 300 es
// SPDX-License-Identifier: MIT
// How deep what a pixel sees is, and what lies behind it, for bit masks: at the size of the occlusion, with the guard
// band.
//
//   surface            interface: view depth
//   depth_back         the first back faces, which end what the surface begins
//   depth_second       with SECOND_LAYER: the first front faces behind those
//   depth_second_back  with SECOND_LAYER: the back faces that end them
//   source_plane       the normal of the surface's plane; without SHADING_NORMALS source_normal has it
//   source_layers      lengths x along the view ray, in radii and as x / (1 + x): r of the first thing, g from its
//                      front to that of the second, b of the second; 1 where it is not known, or nothing is there
precision highp float;  // depths
precision highp int;

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "common/middle_pixel.glsl"
#include "common/view_space.glsl"
#include "ssao/shaders/shading_normals.glsl"

#if !defined(SECOND_LAYER) || !BACK_FACES
#undef SECOND_LAYER
#define SECOND_LAYER 0
#endif

#if !SHADING_NORMALS
#define source_plane source_normal
#endif
uniform mediump sampler2D source_plane;
uniform highp float radius;
uniform vec2 viewport_size;
uniform highp sampler2D depth_back;
#if SECOND_LAYER
uniform highp sampler2D depth_second;
uniform highp sampler2D depth_second_back;
#endif

layout(location = 0) out vec4 source_layers;

// How deep a sheet, whose back is its front, counts in radii: as its depth changes from tap to tap, within bounds. Less
// parts steep sheets, more closes what is open behind leaves. Ours.
const vec2 kSheet = vec2(0.02, 0.5);
const float kSheetBehind = min(3.0 / float(STEPS), kSheet.y);  // its plane is not known
const float kSame = 0.002;  // no more between front and back is a sheet: the two are drawn at different sizes
const float kUnknown = 1e9;

// False where nothing was drawn.
bool pointBehind(highp sampler2D depths, vec2 seen, out vec3 point)
{
    float stored = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    point = viewFromWindow(seen, stored);
    return isDrawn(stored);
}

// In radii: up to the back face, `sheet` where the back is the front, or kUnknown where none was drawn.
float depthOf(highp sampler2D backs, vec2 seen, vec3 front, float sheet)
{
    vec3 back;
    bool closed = pointBehind(backs, seen, back);
    float deep = back.z < front.z ? distance(back, front) / max(radius, 1e-30) : 0.0;
    return !closed ? kUnknown : deep > kSame ? deep : sheet;
}

void main()
{
    vec2 seen = seenUv(uvFromGuardBand(ivec2(gl_FragCoord.xy), viewport_size), viewSizeIn(viewport_size));
    vec3 front;
    vec3 lengths = vec3(0.0, kUnknown, 0.0);
    if (viewPosition(seen, front)) {
        vec3 plane = texelFetch(source_plane, ivec2(gl_FragCoord.xy), 0).xyz * 2.0 - 1.0;
        float facing = clamp(raySlope(front, normalize(plane)), 1e-3, 1.0);
        float change = sqrt(1.0 - facing * facing) / (facing * float(STEPS));
        lengths.x = depthOf(depth_back, seen, front, clamp(change, kSheet.x, kSheet.y));
#if SECOND_LAYER
        vec3 behind;
        if (pointBehind(depth_second, seen, behind))
            lengths.yz = vec2(distance(behind, front) / max(radius, 1e-30),
                              depthOf(depth_second_back, seen, behind, kSheetBehind));
#endif
    }
    lengths = min(lengths, kUnknown);
    source_layers = vec4(lengths / (1.0 + lengths), 1.0);
}
