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
// A neighbour counts if it lies in the pixel's plane, which is that of the neighbour nearest in depth: what lies across
// the near edge of a box does not, at the same depth. Where all four lie on other surfaces, a thin wire say, or on a
// curved one, those nearest in depth serve.
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
const float kMinWeight = 0.1;

// Share of its neighbours' weights on the screen below which a pixel has none.
const float kMissing = 0.1;

// Occlusion, and the share of depth.
void readTexel(ivec2 texel, out mediump float value, out float share)
{
    vec4 stored = texelFetch(ao_low, texel, 0);
    value = stored.r;
#ifdef DEPTH_APART
    share = shareOfDigits(texelFetch(low_depth, texel, 0).rgb);
#else
    share = shareOfDigits(stored.gba);
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
    ivec2 low = max(ivec2(floor(place)), 0);
    ivec2 high = min(ivec2(floor(place)) + 1, size - 1);
    vec2 along = fract(place);
    mediump vec4 values;
    vec4 behind;
    readTexel(low, values.x, behind.x);
    readTexel(ivec2(high.x, low.y), values.y, behind.y);
    readTexel(ivec2(low.x, high.y), values.z, behind.z);
    readTexel(high, values.w, behind.w);
    float share = shareOfZ(z, depthUnit());
    behind = (behind - share) * lengthPerShare(share);

    vec2 low_pixel = pixelSize(share) * viewport_size / vec2(size);
    // From the pixel to each neighbour: across and up in pixels of ao_low; and the share of the screen that is its.
    mediump vec4 across = vec4(-along.x, 1.0 - along.x, -along.x, 1.0 - along.x);
    mediump vec4 up = vec4(-along.yy, 1.0 - along.yy);
    mediump vec4 weights = (1.0 - abs(across)) * (1.0 - abs(up));
    // The plane of the neighbour that is nearest, in depth above all: that of the pixel.
    vec4 apart = abs(behind) / (weights + 0.05);
    ivec2 nearest = low;
    if (apart.y < apart.x) nearest.x = high.x;
    apart.x = min(apart.x, apart.y);
    if (min(apart.z, apart.w) < apart.x) nearest = ivec2(apart.w < apart.z ? high.x : low.x, high.y);
    mediump vec4 stored = texelFetch(source_normal, nearest + (textureSize(source_normal, 0) - size) / 2, 0);
    vec3 normal = normalOf(stored);
    vec4 off = dot(normal, rayThrough(gl_FragCoord.xy)) * behind;
    off = abs(off + normal.x * low_pixel.x * across + normal.y * low_pixel.y * up);
    float noise = 4.0 * toleranceOf(stored.a) * radius;
    vec4 cuts = cutsOf(off, noise, vec4(1.0 / max(low_pixel.x, 1e-20)));
#ifdef MARKS_MISSING
    gl_FragDepth = dot(weights, max(1.0 - cuts, 0.0)) < kMissing ? 1.0 : 0.0;
#endif
    vec4 kept = weights * max(1.0 - cuts, kMinWeight / (1.0 + cuts * cuts));
    ao_filtered = vec4(dot(kept, values) / dot(kept, vec4(1.0)));
}
