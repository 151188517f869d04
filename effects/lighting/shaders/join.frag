#version 300 es
// SPDX-License-Identifier: MIT
// The lesser of what the screen and what the material say.
//
//   ao_filtered, baked_ao  visibility, 1 open .. 0 blocked
//   ao_joined              likewise; a product would darken twice what both know of
// [Lagarde, de Rousiers 2014]
precision mediump float;

#include "common/guard_band.glsl"

uniform mediump sampler2D ao_filtered;
uniform mediump sampler2D baked_ao;

in highp vec2 uv;
layout(location = 0) out float ao_joined;

void main()
{
    highp ivec2 texel = texelInGuardBand(uv, vec2(textureSize(baked_ao, 0)));
    ao_joined = min(texture(ao_filtered, uv).r, texelFetch(baked_ao, texel, 0).r);
}
