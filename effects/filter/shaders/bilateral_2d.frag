#version 300 es
// SPDX-License-Identifier: MIT
// A Gaussian over a square that stops at steps in depth: filter/shaders/bilateral.frag in one pass.
//
//   surface      interface: view depth
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged where no neighbour is near in depth
//
// A tap counts when its depth lies within the cut of the plane through the pixel's own depth and slopes.
// [Tomasi, Manduchi 1998]
precision highp float;  // depths are compared

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "filter/shaders/own_slope.glsl"

uniform mediump sampler2D ao;
uniform float radius;
uniform float depth_cut;

in vec2 uv;
layout(location = 0) out float ao_filtered;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(ao, 0));
    float center_z = viewZAt(uv);
    vec2 slope = vec2(ownSlope(uv, center_z, vec2(texel.x, 0.0)), ownSlope(uv, center_z, vec2(0.0, texel.y)));
    float cut = depth_cut * radius;

    float sum = 0.0;
    float weights = 0.0;
    for (int y = -BLUR_RADIUS; y <= BLUR_RADIUS; ++y) {
        for (int x = -BLUR_RADIUS; x <= BLUR_RADIUS; ++x) {
            vec2 steps = vec2(x, y);
            vec2 ratio = steps * 2.0 / float(BLUR_RADIUS + 1);  // the window ends at two sigma
            vec2 at = uv + texel * steps;
            float error = viewZAt(at) - (center_z + dot(slope, steps));
            bool near = abs(error) < cut || steps == vec2(0.0);
            float weight = near ? exp(-0.5 * dot(ratio, ratio)) : 0.0;
            sum += weight * texture(ao, at).r;
            weights += weight;
        }
    }
    ao_filtered = sum / weights;
}
