#version 300 es
// SPDX-License-Identifier: MIT
// Ambient occlusion by counting offsets, all round a point, that lie behind what the camera sees.
// Half of them are inside the surface, so that a flat wall is grey: the method's own look.
//
//   surface         interface: point in view space; normals are not read
//   kernel          SAMPLES offsets
//   rotation_noise  a tile of unit vectors, one rotation about the view axis a pixel; where ROTATE is 1
//   ao              visibility, 1 open .. 0 blocked; 1 in the background
//   GUARDS          ours: probes behind the camera or off the screen and background do not count, and occlusion fades
//                   where the radius nears a pixel
//
// [Mittring 2007; Meiri n.d.] - the occluded share of offsets.
precision highp float;  // positions and depths; mediump bands

#define SURFACE_WITHOUT_NORMAL
#include <surface>
#include "common/host_picture.glsl"
#include "ssao/shaders/occlusion_curve.glsl"
#include "ssao/shaders/probe.glsl"
#include "ssao/shaders/range_check.glsl"
#include "ssao/shaders/reach.glsl"
#include "ssao/shaders/seen.glsl"

uniform vec3 kernel[SAMPLES];
uniform float range;
#if ROTATE
uniform mediump sampler2D rotation_noise;
uniform vec2 viewport_size;
#endif

in vec2 uv;
layout(location = 0) out float ao;

void main()
{
    vec3 origin;
    if (!viewPosition(uv, origin)) {
        ao = 1.0;
        return;
    }
#if ROTATE
    vec2 at_host = hostPixel(gl_FragCoord.xy, viewport_size);
    vec2 turn = texture(rotation_noise, at_host / vec2(textureSize(rotation_noise, 0))).xy;
    mat3 frame = mat3(turn.x, turn.y, 0.0, -turn.y, turn.x, 0.0, 0.0, 0.0, 1.0);
#else
    const mat3 frame = mat3(1.0);
#endif
    mat3 view_from_kernel = pictureFromHost(frame);
    float occlusion = 0.0;
    float known = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 probe = origin + view_from_kernel * kernel[i] * radius;
        vec2 at;
        if (!uvOfProbe(probe, at)) continue;
        known += 1.0;
        vec3 seen;
        bool drawn = samplePosition(uv, at, seen);
        if ((GUARDS == 1 && !drawn) || seen.z < probe.z) continue;
        occlusion += rangeWeight(origin.z, probe.z, seen.z, radius * range);
    }
#if GUARDS
    vec2 pixel = vec2(dFdx(uv.x), dFdy(uv.y));
    occlusion *= radiusFade(reachOf(origin), pixel);
#endif
    ao = visibilityOf(occlusion / max(known, 1.0));
}
