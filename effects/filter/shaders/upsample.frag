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
// depth. Where all four lie on other surfaces, a thin wire say, or on a curved one, those nearest in depth serve. Where
// they and the pixel all lie on one plane, which is the rule, the texture's own filter does. Ours.
// [Kopf et al. 2007] - bilinear shares times a weight by the full-size picture
precision highp float;  // depths are compared
precision highp int;

#include "common/host_picture.glsl"
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
const float kMissing = 0.1;

// The pixel of ao_low to the lower left of this one, in the host's picture: the first of the square of four about it.
vec2 firstCorner(vec2 place)
{
    return floor(place) + max(-pictureFromHost(vec2(1.0, 0.0)) - pictureFromHost(vec2(0.0, 1.0)), 0.0);
}

vec4 storedAt(ivec2 texel)
{
    vec4 stored = texelFetch(ao_low, texel, 0);
#ifdef DEPTH_APART
    stored.gba = texelFetch(low_depth, texel, 0).rgb;
#endif
    return stored;
}

// Whether the square about this pixel is marked as flat and the pixel lies on it: the slope of depth from pixel to pixel,
// which leads nowhere across an edge, leads to its first one.
bool isOnMarkedSquare(float share)
{
    vec2 slope = vec2(dFdx(share), dFdy(share));
    vec2 size = vec2(textureSize(ao_low, 0));
    vec2 scale = viewport_size / size;
    vec2 place = uv * size - 0.5;
    vec2 corner = clamp(firstCorner(place), vec2(0.0), size - 1.0);
    vec4 stored = storedAt(ivec2(corner));
    float off = shareOfDigits(stored.gba) - share - dot(slope * scale, corner - place);
    return isMarked(stored.gba) && isOnPlane(abs(off) * lengthPerShare(share), abs(pixelSize(share).x) * scale.x);
}

void main()
{
    float z = viewZAt(uv);
    float share = shareOfZ(z, depthUnit());
    bool drawn = z > kBackgroundZ;
    int corners = !isOnMarkedSquare(share) && drawn ? 4 : 0;
    float value = drawn ? textureLod(ao_low, uv, 0.0).r : 1.0;
    // What does not change is computed within: kept from run to run, it would take more than the 32 registers that a
    // phone's core has for full speed.
    float seen = 0.0;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < corners; ++i) {
        vec2 size = vec2(textureSize(ao_low, 0));
        vec2 place = uv * size - 0.5;
        float up = step(1.5, float(i));
        vec2 right = pictureFromHost(vec2(1.0, 0.0));
        vec2 above = pictureFromHost(vec2(0.0, 1.0));
        vec2 corner = firstCorner(place) + (float(i) - 2.0 * up) * right + up * above;
        ivec2 texel = ivec2(clamp(corner, vec2(0.0), size - 1.0));
        vec4 stored = storedAt(texel);
        ivec2 band = (textureSize(source_normal, 0) - textureSize(ao_low, 0)) / 2;
        mediump vec4 plane = texelFetch(source_normal, texel + band, 0);
        vec3 normal = normalOf(plane);
        vec2 away = corner - place;
        vec2 low_pixel = pixelSize(share) * viewport_size / size;
        float off = dot(normal, rayThrough(gl_FragCoord.xy)) * (shareOfDigits(stored.gba) - share) * lengthPerShare(share) +
                    dot(normal.xy * away, low_pixel);
        float cut = cutOf(off, plane, low_pixel.x);
        vec2 nearness = 1.0 - abs(away);
        float near = nearness.x * nearness.y;
        seen += near * max(1.0 - cut, 0.0);
        sum += near * max(1.0 - cut, kMinWeight / (1.0 + cut * cut)) * vec2(stored.r, 1.0);
        if (i + 1 >= corners) break;
    }
    if (corners > 0) value = sum.x / max(sum.y, 1e-20);
    ao_filtered = vec4(value);
#ifdef MARKS_MISSING
    gl_FragDepth = corners > 0 && seen < kMissing ? 1.0 : 0.0;
#endif
}
