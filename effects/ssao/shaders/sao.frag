#version 300 es
// SPDX-License-Identifier: MIT
// Scalable ambient obscurance: taps on a spiral about the pixel, each of which occludes by how high over
// the surface its own surface stands and by how near it is.
//
//   surface  interface: point and normal in view space
//   ao       visibility, 1 open .. 0 blocked; 1 in the background
//   CURVE    how a tap's weight falls: soft, or steep, which is dark in creases and light elsewhere
//
// Spiral and weights are the authors' own, with lengths counted in radii where they have metres; their half step of
// the spiral is noise here. Variants B and C are those of the shader that they published with the paper.
// [McGuire et al. 2012]
precision highp float;  // positions and depths; mediump bands

#include <surface>
#include "common/host_picture.glsl"
#include "common/pixel_noise.glsl"
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/shaders/reach.glsl"
#include "ssao/shaders/seen.glsl"

uniform float bias;
uniform float turns;
uniform vec2 viewport_size;

in vec2 uv;
layout(location = 0) out float ao;

const float kWhole = 6.28318531;  // of a turn, in radians

#if CURVE == CURVE_STEEP
// Keeps a tap at the point itself from counting without end; a share of the radius squared. The authors' epsilon.
const float kNearest = 0.01;

// Variant B, which they recommend, and the factor 5 of their sum.
float weightOf(float height, float distance2)
{
    float inside = max(1.0 - distance2, 0.0);
    return 5.0 * inside * inside * inside * max(height, 0.0) / (distance2 + kNearest);
}
#else
// Variant C, for large radii, without that factor: rmse in the room, power 1, 0.176; with it 0.229.
float weightOf(float height, float distance2)
{
    return 4.0 * max(1.0 - distance2, 0.0) * max(height, 0.0);
}
#endif

void main()
{
    vec3 point;
    if (!viewPosition(uv, point)) {
        ao = 1.0;
        return;
    }
    float per_radius = 1.0 / max(radius, 1e-18);
    vec3 up = normalAt(uv);
    float lift = max(bias, depthTolerance(point, up, radius) * per_radius);
    vec2 reach = reachOf(point);
    vec2 pixel = vec2(dFdx(uv.x), dFdy(uv.y));
    vec2 noise = pixelNoise(hostPixel(gl_FragCoord.xy, viewport_size));

    float first = kWhole * (noise.x + turns * noise.y / float(SAMPLES));
    vec2 direction = vec2(cos(first), sin(first));
    float step_angle = kWhole * turns / float(SAMPLES);
    vec2 turn = vec2(cos(step_angle), sin(step_angle));

    float occlusion = 0.0;
    float known = 0.0;  // taps off the screen say nothing, either way
    for (int i = 0; i < SAMPLES; ++i) {
        float share = (float(i) + noise.y) / float(SAMPLES);
        vec2 at = uv + share * reach * pictureFromHost(direction);
        direction = vec2(turn.x * direction.x - turn.y * direction.y,
                         turn.x * direction.y + turn.y * direction.x);
        if (!isCaptured(at)) continue;
        known += 1.0;
        vec3 seen;
        if (!samplePosition(uv, at, seen)) continue;
        vec3 offset = (seen - point) * per_radius;
        occlusion += weightOf(dot(offset, up) - lift, dot(offset, offset));
    }
    ao = visibilityOf(radiusFade(reach, pixel) * occlusion / max(known, 1.0));
}
