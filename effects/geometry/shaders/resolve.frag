#version 310 es
// SPDX-License-Identifier: MIT
// Of a pixel's samples the one in the middle by depth, of an even count the nearer of the two: whole, never
// a mean, which would lie on no surface.
//
//   depth_samples   window depth
//   normal_samples  stored normals; with RESOLVE_NORMAL
//   HOST_SAMPLES    samples a pixel
//   normal          of the sample whose depth is written
//
// The nearest sample moves silhouettes and the faces of corners towards the camera by half a pixel, the first
// one moves the picture by its place in the pixel; the middle stays on most of the pixel and near its centre.
precision highp float;
precision highp int;

#include "common/texel.glsl"

uniform vec2 viewport_size;
uniform highp sampler2DMS depth_samples;
#if RESOLVE_NORMAL
uniform highp sampler2DMS normal_samples;

layout(location = 0) out vec4 normal;
#endif

#if CAMERA_REVERSED_DEPTH
const int kMiddle = HOST_SAMPLES / 2;
#else
const int kMiddle = (HOST_SAMPLES - 1) / 2;
#endif

void main()
{
    ivec2 texel = texelAt(gl_FragCoord.xy / viewport_size, vec2(textureSize(depth_samples)));
    float depths[HOST_SAMPLES];
    for (int i = 0; i < HOST_SAMPLES; ++i) depths[i] = texelFetch(depth_samples, texel, i).r;
    int middle = 0;
    float middle_depth = depths[0];
    for (int i = 0; i < HOST_SAMPLES; ++i) {
        int before = 0;  // samples that come before this one, by depth and then by number
        for (int j = 0; j < HOST_SAMPLES; ++j)
            before += int(depths[j] < depths[i] || (j < i && depths[j] == depths[i]));
        if (before != kMiddle) continue;
        middle = i;
        middle_depth = depths[i];
    }
    gl_FragDepth = middle_depth;
#if RESOLVE_NORMAL
    normal = texelFetch(normal_samples, texel, middle);
#endif
}
