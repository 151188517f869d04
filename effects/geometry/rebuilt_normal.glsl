// SPDX-License-Identifier: MIT
// Normals from a depth texture alone.
//
// Window depth runs straight over the screen on every plane, for any projection. So the two texels to
// each side foretell the depth at hand, and the side that does so better lies on the same surface: edges
// stay sharp, where plain differences would bend them.
// [Wu 2020, "Accurate Normal Reconstruction from Depth Buffer" - the choice by two texels a side]

#include "common/texel.glsl"
#include "common/view_space.glsl"

// Depth error of a side that ends at the texture's edge: more than any other.
const highp float kNoSide = 2.0;

// Off the edge the nearest texel stands in.
highp float depthNear(highp sampler2D depths, highp ivec2 texel)
{
    highp ivec2 last = textureSize(depths, 0) - 1;
    return texelFetch(depths, clamp(texel, ivec2(0), last), 0).r;
}

// How far the texels at one and two `step`s are from foretelling the depth `here`.
highp float sideError(highp sampler2D depths, highp ivec2 texel, highp ivec2 step, highp float here,
                      highp float near)
{
    highp ivec2 end = texel + 2 * step;
    highp ivec2 size = textureSize(depths, 0);
    if (min(end.x, end.y) < 0 || end.x >= size.x || end.y >= size.y) return kNoSide;
    return abs(2.0 * near - texelFetch(depths, end, 0).r - here);
}

highp vec3 pointOfTexel(highp vec2 size, highp ivec2 texel, highp float stored)
{
    return viewFromWindow(uvFromGuard((vec2(texel) + 0.5) / size), stored);
}

// The way from the texel to the next one along `step` on the same surface, of no certain length.
highp vec3 alongSurface(highp sampler2D depths, highp ivec2 texel, highp ivec2 step, highp float here,
                        highp vec3 point)
{
    highp vec2 size = vec2(textureSize(depths, 0));
    highp float behind = depthNear(depths, texel - step);
    highp float ahead = depthNear(depths, texel + step);
    highp float error_behind = sideError(depths, texel, -step, here, behind);
    highp float error_ahead = sideError(depths, texel, step, here, ahead);
    highp vec3 way = error_behind < error_ahead
                         ? point - pointOfTexel(size, texel - step, behind)
                         : pointOfTexel(size, texel + step, ahead) - point;
    return way / max(max(abs(way.x), max(abs(way.y), abs(way.z))), 1e-30);
}

// The unit normal in view space at the view's uv, towards the camera.
highp vec3 rebuiltNormal(highp sampler2D depths, highp vec2 at)
{
    highp vec2 size = vec2(textureSize(depths, 0));
    highp ivec2 texel = texelAt(uvInGuard(at), size);
    highp float here = texelFetch(depths, texel, 0).r;
    highp vec3 point = pointOfTexel(size, texel, here);
    highp vec3 normal = cross(alongSurface(depths, texel, ivec2(1, 0), here, point),
                              alongSurface(depths, texel, ivec2(0, 1), here, point));
    highp float length_squared = dot(normal, normal);
    return length_squared > 0.0 ? normal * inversesqrt(length_squared) : vec3(0.0, 0.0, 1.0);
}
