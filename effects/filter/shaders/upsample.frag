#version 300 es
// SPDX-License-Identifier: MIT
// Full-size occlusion from that of fewer pixels: the mean of the four nearest, by nearness on screen and in depth.
//
//   surface        interface: view depth, at full size
//   source_normal  normals at the size of ao_low, with the guard band
//   ao_low         occlusion at a lower resolution in r, and the digits of its share of depth in gba
//   low_depth      with DEPTH_APART: those digits in rgb
//   ao_filtered    the weighted mean; 1 in the background
//   missing        with MARKS_MISSING, a mask: 1 where no neighbour counts (ssao/march_missing.json), 0 elsewhere
//
// A neighbour counts if the pixel lies in its plane: what lies across the near edge of a box does not, at the same
// depth. Where all four lie on other surfaces, a thin wire say, or on a curved one, those nearest in depth serve.
// [Kopf et al. 2007] - bilinear shares times a weight by the full-size picture
precision highp float;  // depths are compared
precision highp int;

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "filter/shaders/off_plane.glsl"

uniform highp sampler2D ao_low;  // its digits make up 24 bits
#ifdef DEPTH_APART
uniform highp sampler2D low_depth;
#endif
uniform vec2 viewport_size;

in vec2 uv;
layout(location = 0) out vec4 ao_filtered;  // four: beside a depth, Mesa 22.3 for Mali crashes on fewer

// Share of its weight on the screen that a neighbour off the plane keeps, the less the farther: without any, thin
// objects would have no value at all, and with one that does not fall, round ones take on what lies behind them.
const float kMinWeight = 0.03;

// Share of its neighbours' weights on the screen below which a pixel has none.
const float kMissing = 0.2;

// Occlusion, and the share of depth.
vec2 valueAt(ivec2 texel)
{
    vec4 stored = texelFetch(ao_low, texel, 0);
#ifdef DEPTH_APART
    return vec2(stored.r, shareOfDigits(texelFetch(low_depth, texel, 0).rgb));
#else
    return vec2(stored.r, shareOfDigits(stored.gba));
#endif
}

void main()
{
    float z = viewZAt(uv);
#ifdef MARKS_MISSING
    gl_FragDepth = 0.0;
#endif
    if (z <= kBackgroundZ) {
        ao_filtered = vec4(1.0);
        return;
    }
    ivec2 size = textureSize(ao_low, 0);
    vec2 place = uv * vec2(size) - 0.5;
    ivec2 first = ivec2(floor(place));
    vec2 along = place - vec2(first);
    ivec2 low = max(first, 0);
    ivec2 high = min(first + 1, size - 1);
    vec2 a = valueAt(low);
    vec2 b = valueAt(ivec2(high.x, low.y));
    vec2 c = valueAt(ivec2(low.x, high.y));
    vec2 d = valueAt(high);

    // From the pixel to each neighbour: across and up in pixels of ao_low, and in depth.
    vec4 across = vec4(-along.x, 1.0 - along.x, -along.x, 1.0 - along.x);
    vec4 up = vec4(-along.yy, 1.0 - along.yy);
    float share = shareOfZ(z, depthUnit());
    vec4 behind = (vec4(a.y, b.y, c.y, d.y) - share) * lengthPerShare(share);
    // From each neighbour's plane.
    ivec2 band = (textureSize(source_normal, 0) - size) / 2;
    vec3 ray = rayThrough(gl_FragCoord.xy);
    vec2 low_pixel = pixelSize(share) * viewport_size / vec2(size);
    vec4 stored = texelFetch(source_normal, low + band, 0);
    vec3 normal_a = normalOf(stored);
    vec3 normal_b = normalOf(texelFetch(source_normal, ivec2(high.x, low.y) + band, 0));
    vec3 normal_c = normalOf(texelFetch(source_normal, ivec2(low.x, high.y) + band, 0));
    vec3 normal_d = normalOf(texelFetch(source_normal, high + band, 0));
    vec4 off = vec4(dot(normal_a, ray), dot(normal_b, ray), dot(normal_c, ray), dot(normal_d, ray)) * behind;
    off += vec4(normal_a.x, normal_b.x, normal_c.x, normal_d.x) * across * low_pixel.x;
    off += vec4(normal_a.y, normal_b.y, normal_c.y, normal_d.y) * up * low_pixel.y;
    float noise = 4.0 * toleranceOf(stored.a) * radius;
    vec4 cuts = cutsOf(abs(off), noise, vec4(1.0 / max(low_pixel.x, 1e-20)));
    vec4 weights = (1.0 - abs(across)) * (1.0 - abs(up)) * max(1.0 - cuts, kMinWeight / (1.0 + cuts * cuts));
#ifdef MARKS_MISSING
    gl_FragDepth = dot((1.0 - abs(across)) * (1.0 - abs(up)), max(1.0 - cuts, 0.0)) < kMissing ? 1.0 : 0.0;
#endif
    ao_filtered = vec4(dot(weights, vec4(a.x, b.x, c.x, d.x)) / dot(weights, vec4(1.0)));
}
