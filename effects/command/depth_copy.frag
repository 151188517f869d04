#version 300 es
// SPDX-License-Identifier: MIT
// A texel read, a texel written: what any pass over the depth texture costs at least.
//
//   depth  window-space depth
//   copy   the same
precision highp float;

uniform highp sampler2D depth;

layout(location = 0) out float copy;

void main()
{
    copy = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r;
}
