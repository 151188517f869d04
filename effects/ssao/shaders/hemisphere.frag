#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion by counting offsets, in the hemisphere over the surface, that lie behind what the
// camera sees.
//
//   surface         interface: point and normal in view space
//   kernel          SAMPLES offsets in the unit hemisphere about +z
//   rotation_noise  a tile of vectors, one rotation about the normal a pixel
//   ao              visibility, 1 open .. 0 blocked; 1 in the background
//   BIAS_ALONG      view: an occluder must lie the bias in front of an offset; normal: the offsets stand about a
//                   point that is lifted off its surface by the bias
//   POWER_OF        of the visibility, as usual, or of the occlusion
//   BASIS           rotated: a frame about the normal, turned by the noise; else the noise's part across the normal is
//                   t, and the third axis is n x t or t x n
//   GUARDS          what the authors' shaders lack: probes behind the camera or off the screen and background do not
//                   count, nor does what lies in the tangent plane; the bias is a step of the depth at least
//   WITH_BOUNCE     also what the occluders reflect:
//   direct          linear colour that surfaces reflect
//   indirect        linear colour that the point gets from them
//
// [Filion, McNaughton 2008; Chapman 2013] - the occluded share of offsets. [de Vries 2020] - the bias.
// [Habr n.d.] - the lifted point. [Ritschel et al. 2009] - the bounce.
precision highp float;  // positions and depths; mediump bands

#include "common/host_picture.glsl"
#include "common/tangent_frame.glsl"
#include "common/view_space.glsl"
#include <surface>
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/shaders/probe.glsl"
#include "ssao/shaders/range_check.glsl"
#include "ssao/shaders/seen.glsl"

uniform vec3 kernel[SAMPLES];
uniform mediump sampler2D rotation_noise;
uniform float radius;
uniform float range;
uniform float bias;
uniform float bias_length;
uniform float contrast;
uniform vec2 viewport_size;

#ifdef WITH_BOUNCE
uniform mediump sampler2D direct;
uniform float bounce;
#endif

in vec2 uv;
layout(location = 0) out float ao;
#ifdef WITH_BOUNCE
layout(location = 1) out vec4 indirect;

// What the surface seen at `at` reflects, if it faces the point. The authors also weigh it by the cosines at both ends
// over the squared distance, which has no bound in creases; here it counts as the direction that it blocks.
vec3 reflectedFrom(vec2 at, vec3 seen, vec3 point)
{
    return dot(normalAt(at), point - seen) > 0.0 ? texture(direct, at).rgb : vec3(0.0);
}
#endif

// [Gedge 2014: the prose raises the occlusion to a power, the code the visibility]
// [Lettier 2019 - the contrast]
float shown(float occlusion)
{
#if POWER_OF == POWER_OF_OCCLUSION
    float open = 1.0 - pow(clamp(intensity * occlusion, 0.0, 1.0), power);
#else
    float open = visibilityOf(occlusion);
#endif
    return clamp((open - 0.5) * contrast + 0.5, 0.0, 1.0);
}

// All of the host's own picture.
mat3 frameAt(vec3 normal)
{
    vec2 pixel = hostPixel(gl_FragCoord.xy, viewport_size);
    vec2 noise = texture(rotation_noise, pixel / vec2(textureSize(rotation_noise, 0))).xy;
#if BASIS == BASIS_ROTATED
    return rotatedFrame(normal, noise);
#elif BASIS == BASIS_N_CROSS_T
    return projectedFrame(normal, vec3(noise, 0.0));
#else
    mat3 frame = projectedFrame(normal, vec3(noise, 0.0));
    return mat3(frame[0], -frame[1], frame[2]);
#endif
}

void main()
{
    vec3 origin;
    if (!viewPosition(uv, origin)) {
        ao = 1.0;
#ifdef WITH_BOUNCE
        indirect = vec4(0.0);
#endif
        return;
    }
    vec3 normal_here = normalAt(uv);
    float lift = bias * radius + bias_length;
#if GUARDS
    lift = max(lift, depthTolerance(origin, normal_here, radius));
#endif
    mat3 view_from_kernel = pictureFromHost(frameAt(hostFromPicture(normal_here)));
#if BIAS_ALONG == BIAS_ALONG_NORMAL
    vec3 center = origin + normal_here * lift;
    const float in_front = 0.0;
#else
    vec3 center = origin;
    float in_front = lift;
#endif

    float occlusion = 0.0;
#ifdef WITH_BOUNCE
    vec3 reflected = vec3(0.0);
#endif
#if GUARDS
    float known = 0.0;
#else
    const float known = float(SAMPLES);
#endif
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 probe = center + view_from_kernel * kernel[i] * radius;
        vec2 at;
        if (!uvOfProbe(probe, at)) continue;
        vec3 seen;
        bool drawn = samplePosition(uv, at, seen);
#if GUARDS
        known += 1.0;
        // What lies in the tangent plane cannot occlude; without this a plane seen at a grazing angle
        // shades itself, since a texel's one depth stands for all of its slope.
        bool above = dot(seen - origin, normal_here) > lift;
        if (!drawn || !above) continue;
#endif
        // Chosen and not skipped: pixels side by side seldom agree.
        float weight = seen.z < probe.z + in_front ? 0.0 : rangeWeight(origin.z, probe.z, seen.z, radius * range);
        occlusion += weight;
#ifdef WITH_BOUNCE
        if (weight > 0.0) reflected += weight * reflectedFrom(at, seen, origin);
#endif
    }
    ao = shown(occlusion / max(known, 1.0));
#ifdef WITH_BOUNCE
    indirect = vec4(reflected * (intensity * bounce / max(known, 1.0)), 1.0);
#endif
}
