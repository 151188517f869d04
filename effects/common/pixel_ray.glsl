// SPDX-License-Identifier: MIT
// The rays of a camera through the pixels of a pass.

#include "common/depth_share.glsl"

uniform highp mat3 ray_from_pixel;

// Along the ray through a pixel, whose middle is at + 0.5, for a change of 1 in view depth.
highp vec3 rayThrough(highp vec2 pixel)
{
#if CAMERA_ORTHOGRAPHIC
    return vec3(0.0, 0.0, 1.0);
#else
    return vec3((ray_from_pixel * vec3(pixel, 1.0)).xy, 1.0);
#endif
}

// One pixel of the pass, in scene units at a share of depth.
highp vec2 pixelSize(highp float share)
{
    highp vec2 size = vec2(ray_from_pixel[0].x, ray_from_pixel[1].y);
#if !CAMERA_ORTHOGRAPHIC
    size *= zOfShare(max(share, kFarthestShare), depthUnit());
#endif
    return size;
}
