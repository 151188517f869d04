#version 300 es
// SPDX-License-Identifier: MIT
// Coarser copies of depth, all in one texture.
//
//   whole_depth  window depth, of any size
precision highp float;
precision highp int;

#include "common/depth_levels.glsl"
#include "common/texel.glsl"

uniform highp sampler2D whole_depth;
uniform vec2 viewport_size;

void main()
{
    ivec2 size = ivec2(viewport_size);
    ivec2 here = ivec2(gl_FragCoord.xy);
    for (int level = 1; level <= kDepthLevels; ++level) {
        ivec2 at = here - levelCorner(level, size);
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size >> level))) continue;
        vec2 place = (vec2(levelSource(level, at)) + 0.5) / viewport_size;
        gl_FragDepth = texelFetch(whole_depth, texelAt(place, vec2(textureSize(whole_depth, 0))), 0).r;
        return;
    }
    discard;
}
