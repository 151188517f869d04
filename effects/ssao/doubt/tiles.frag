#version 300 es
// SPDX-License-Identifier: MIT
// How far occlusion may be off in each tile of 4x4 texels of `ao`, told from what the estimator had to go on.
//
//   ao            unfiltered occlusion
//   source_depth  view depth as a share, with the guard band; 0 in the background
//   doubt_tile    x: share of the root of the darkness that the error is expected to be; y: the error; z: 1 if a surface
//
// The square of the error is expected to be the darkness times a sum of three squares, each with a weight that is fitted:
// the spread of the tile's values, for a few samples that differ stand for many that were not taken; the mean over four
// directions of the step towards the camera, within the radius, behind which nobody knows what blocks; and a pixel in
// radii, below which nothing is seen. All in radii, a step of more than one as one. Ours; docs/reference/doubt.md.
precision highp float;  // as depths are

#include "common/host_picture.glsl"
#include "common/pixel_ray.glsl"
#include "common/uneven_step.glsl"

uniform mediump sampler2D ao;
uniform highp sampler2D source_depth;
uniform vec2 viewport_size;
uniform float doubt_noise;
uniform float doubt_hidden;
uniform float doubt_pixel;

layout(location = 0) out vec4 doubt_tile;

// Where depth is looked at, in radii from the tile's middle.
const float kNear = 0.25;
const float kFar = 0.75;

// How far away the surface at a place in `ao` is, in radii; what is not known is as far as `center`.
float distanceAt(vec2 place, vec2 band, float center)
{
    vec2 texel = floor(place + band);
    vec2 most = vec2(textureSize(source_depth, 0)) - 1.0;
    if (any(lessThan(texel, vec2(0.0))) || any(greaterThan(texel, most))) return center;
    float share = texelFetch(source_depth, ivec2(texel), 0).r;
    return -zOfShare(max(share, kFarthestShare), depthUnit()) / usedRadius();
}

vec4 distancesAt(vec2 middle, vec2 along, float radii, vec2 radius, vec2 band, float center)
{
    vec2 way = along * max(radii * radius, vec2(1.5));
    vec2 across = vec2(-along.y, along.x) * max(radii * radius, vec2(1.5));
    return vec4(distanceAt(middle + way, band, center), distanceAt(middle + across, band, center),
                distanceAt(middle - way, band, center), distanceAt(middle - across, band, center));
}

void main()
{
    ivec2 size = textureSize(ao, 0);
    ivec2 first = ivec2(gl_FragCoord.xy) * 4;
    vec2 middle = min(vec2(first) + 2.0, vec2(size) - 0.5);
    vec2 band = 0.5 * vec2(textureSize(source_depth, 0) - size);
    float share = texelFetch(source_depth, ivec2(floor(middle + band)), 0).r;
    doubt_tile = vec4(0.0);
    if (share == 0.0) return;

    float sum = 0.0;
    float squares = 0.0;
    for (int i = 0; i < 16; ++i) {
        float value = texelFetch(ao, min(first + ivec2(i & 3, i >> 2), size - 1), 0).r;
        sum += value;
        squares += value * value;
    }
    float mean = sum / 16.0;
    float noise = max(squares / 16.0 - mean * mean, 0.0);

    float center = -zOfShare(share, depthUnit()) / usedRadius();
    vec2 pixel = abs(pixelSize(share)) * viewport_size / (vec2(size) * usedRadius());
    vec2 radius = 1.0 / max(pixel, vec2(1e-6));
    // The four directions of every second tile lie between those of the others.
    ivec2 tile = ivec2(gl_FragCoord.xy);
    float angle = 0.39269908 + 0.78539816 * float((tile.x + tile.y) & 1);
    vec2 along = pictureFromHost(vec2(cos(angle), sin(angle)));
    vec4 near = distancesAt(middle, along, kNear, radius, band, center);
    vec4 far = distancesAt(middle, along, kFar, radius, band, center);
    vec4 rise = (near - center) / kNear;
    vec4 second = unevenStep((far - near) / (kFar - kNear), rise) * (kFar - kNear);
    vec4 step_nearer = max(-unevenStep(rise, -rise.zwxy) * kNear, -second);
    float hidden = dot(clamp(step_nearer, 0.0, 1.0), vec4(0.25));
    float coarse = min(max(pixel.x, pixel.y), 1.0);

    float square = doubt_noise * noise + doubt_hidden * hidden * hidden + doubt_pixel * coarse * coarse;
    doubt_tile = vec4(sqrt(square), sqrt(square * (1.0 - mean)), 1.0, 1.0);
}
