#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a separable Gaussian whose width follows the occlusion radius on the screen.
//
//   surface      interface: view depth, of the pixel alone; edges are blurred
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged in the background
//   AXIS         vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// What is far away is blurred less, so that a surface keeps its look as the camera moves: ours. The
// weights come from two products a tap instead of an exponential. [Turkowski 2007]
precision highp float;  // depths, and products that fall by many powers of two

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "common/host_picture.glsl"
#include "common/view_space.glsl"

uniform mediump sampler2D ao;
uniform float radius;
uniform float sigma;

in vec2 uv;
layout(location = 0) out float ao_filtered;

// The standard deviation at a pixel, in pixels along the axis, at most half of the window.
float sigmaInPixels(vec2 axis, vec2 size)
{
#if CAMERA_ORTHOGRAPHIC
    float w = viewZAt(uv) > -1e20 ? 1.0 : 1e30;
#else
    float w = max(-viewZAt(uv), 1e-18);
#endif
    vec2 pixels = 0.5 * size * vec2(clip_from_view[0][0], clip_from_view[1][1]);
    return min(sigma * radius / w * dot(axis, pixels), 0.5 * float(BLUR_RADIUS + 1));
}

void main()
{
    vec2 size = vec2(textureSize(ao, 0));
    vec2 axis = abs(pictureFromHost(AXIS));
    vec2 texel = axis / size;
    float deviation = max(sigmaInPixels(axis, size), 0.05);  // below it every neighbour's weight, exp(-200), is 0 in float
    float factor = exp(-0.5 / (deviation * deviation));
    float squared = factor * factor;
    float weight = 1.0;
    float sum = texture(ao, uv).r;
    float weights = 1.0;
    for (int i = 1; i <= BLUR_RADIUS; ++i) {
        weight *= factor;
        factor *= squared;
        vec2 offset = float(i) * texel;
        sum += weight * (texture(ao, uv - offset).r + texture(ao, uv + offset).r);
        weights += 2.0 * weight;
    }
    ao_filtered = sum / weights;
}
