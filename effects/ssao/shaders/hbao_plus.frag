#version 300 es
// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion within 4x4 tiles of every fourth pixel: all of a tile marches along the same
// directions and reads only its own texels.
//
//   depth_tiles, normal_tiles  what the pass before sorted into tiles
//   stored_depth               has the view's size
//   ao_tiles                   visibility in the same tiles, 1 open .. 0 blocked; 1 in the background
//
// [Bavoil, Sainz 2008, "Image-Space Horizon-Based Ambient Occlusion"]
// [Bavoil, Jansen 2013, "Particle Shadows & Cache-Efficient Post-Processing"]
precision highp float;  // positions and depths; mediump bands
precision highp int;

#include "common/view_space.glsl"
#include "ssao/shaders/tiles.glsl"

uniform highp sampler2D depth_tiles;
uniform mediump sampler2D normal_tiles;

// What the march asks of a surface: the nearest pixel of the own tile, false in the background and off the view.
bool viewPosition(vec2 at, out vec3 point)
{
    ivec2 tile = textureSize(depth_tiles, 0) / 4;
    ivec2 which = ivec2(gl_FragCoord.xy) / tile;
    ivec2 last = (viewPixels() - 1 - which) / 4;
    ivec2 nearest = ivec2(floor((at * vec2(viewPixels()) - vec2(which) + 1.5) * 0.25));
    ivec2 local = clamp(nearest, ivec2(0), last);
    float stored = texelFetch(depth_tiles, which * tile + local, 0).r;
    point = viewFromWindow(uvOfPixel(4 * local + which), stored);
    return isDrawn(stored) && at == clamp(at, 0.0, 1.0);
}

float depthTolerance(vec3 point, vec3 normal, float reach)
{
    return viewStepOf(DEPTH_STEP, point) * raySlope(point, normal);
}

#define SEEN_IN_TILES
#include "ssao/shaders/hbao.glsl"
#include "ssao/shaders/occlusion_curve.glsl"

layout(location = 0) out float ao_tiles;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy);
    ivec2 pixel = pixelOfTexel(texel, textureSize(depth_tiles, 0) / 4);
    vec2 uv = uvOfPixel(pixel);
    vec3 point;
    if (!viewPosition(uv, point)) {
        ao_tiles = 1.0;
        return;
    }
    vec3 normal = normalize(texelFetch(normal_tiles, texel, 0).xyz * 2.0 - 1.0);
    vec2 size = vec2(viewPixels());
    vec2 at = hostPixel(vec2(pixel) + 0.5, size) - 0.5;
    March march = marchFrom(uv, at, 4.0 / size, point, normal);
    ao_tiles = visibilityOf(occlusionOf(march));
}
