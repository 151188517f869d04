// SPDX-License-Identifier: MIT
// Points from depth textures, for any projection.

#include "common/view_space.glsl"

// The point in view space that the texel at the view's uv holds, at its centre; false where nothing was drawn.
bool pointIn(highp sampler2D depths, highp vec2 at, out highp vec3 point)
{
    highp vec2 size = vec2(textureSize(depths, 0));
    highp ivec2 texel = texelInGuardBand(at, size);
    highp float stored = texelFetch(depths, texel, 0).r;
    point = viewFromWindow(uvFromGuardBand(texel, size), stored);
    return isDrawn(stored);
}
