#version 300 es
// SPDX-License-Identifier: MIT
// Full-size occlusion from that of fewer pixels: the mean of the four nearest by how near they lie on the
// screen and to the pixel's tangent plane.
//
//   surface      interface: point and normal in view space, at full size
//   normal_low   normals at that of ao_low
//   ao_low       occlusion at a lower resolution, each pixel that of the surface at its uv
//   ao_filtered  the weighted mean; 1 in the background
//
// Where all four lie on other surfaces, a thin wire say, or on a curved one, those nearest to the plane serve.
// [Kopf et al. 2007, "Joint Bilateral Upsampling"] - bilinear shares times a weight by the full-size picture
precision highp float;  // positions are compared

#include "filter/shaders/near_plane.glsl"

uniform mediump sampler2D ao_low;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// Share of its weight on the screen that a neighbour off the plane keeps, the less the farther: without any, thin
// objects would have no value at all, and with one that does not fall, round ones take on what lies behind them.
const float kMinWeight = 0.03;

// What the low-resolution pixel adds to the weighted sum, and its weight.
vec2 tapAt(vec2 corner, vec2 texel, vec2 toward, vec2 share, Here here)
{
    vec2 at = clamp((corner + toward) * texel, 0.5 * texel, 1.0 - 0.5 * texel);
    vec2 shares = mix(1.0 - share, share, toward);
    float cuts = cutsOf(at, here);
    float weight = shares.x * shares.y * max(here.whole - cuts, kMinWeight / (1.0 + cuts * cuts));
    return weight * vec2(texture(ao_low, at).r, 1.0);
}

void main()
{
    ao_filtered = 1.0;
    Here here;
    if (!hereAt(uv, normalAt(uv), here)) return;
    vec2 size = vec2(textureSize(ao_low, 0));
    vec2 place = uv * size - 0.5;
    vec2 share = fract(place);
    vec2 corner = floor(place) + 0.5;
    vec2 texel = 1.0 / size;
    vec2 sum = tapAt(corner, texel, vec2(0.0, 0.0), share, here);
    sum += tapAt(corner, texel, vec2(1.0, 0.0), share, here);
    sum += tapAt(corner, texel, vec2(0.0, 1.0), share, here);
    sum += tapAt(corner, texel, vec2(1.0, 1.0), share, here);
    ao_filtered = sum.x / sum.y;
}
