#version 300 es
// SPDX-License-Identifier: MIT
// One direction of a separable Gaussian that stops at steps in depth.
//
//   surface      interface: view depth
//   ao           what is filtered
//   ao_filtered  the weighted mean; unchanged where no neighbour is near in depth
//   AXIS         vec2(1.0, 0.0) or vec2(0.0, 1.0)
//
// A tap counts when its depth lies within the cut of the line through the pixel's own depth and slope.
// [Tomasi, Manduchi 1998]
precision highp float;  // depths are compared

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "common/host_picture.glsl"
#include "filter/shaders/own_slope.glsl"

uniform mediump sampler2D ao;
uniform float radius;
uniform float depth_cut;

in vec2 uv;
layout(location = 0) out float ao_filtered;

void main()
{
    vec2 texel = pictureFromHost(AXIS) / vec2(textureSize(ao, 0));
    float center_z = viewZAt(uv);
    float slope = ownSlope(uv, center_z, texel);
    float cut = depth_cut * radius;

    float sum = texture(ao, uv).r;
    float weights = 1.0;
    for (int i = 1; i <= BLUR_RADIUS; ++i) {
        float ratio = float(i) * 2.0 / float(BLUR_RADIUS + 1);  // the window ends at two sigma, beyond which 5 % lie
        float gaussian = exp(-0.5 * ratio * ratio);
        for (int side = -1; side <= 1; side += 2) {
            float steps = float(side * i);
            vec2 at = uv + texel * steps;
            float error = viewZAt(at) - (center_z + slope * steps);
            float weight = abs(error) < cut ? gaussian : 0.0;
            sum += weight * texture(ao, at).r;
            weights += weight;
        }
    }
    ao_filtered = sum / weights;
}
