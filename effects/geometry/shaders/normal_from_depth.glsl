// SPDX-License-Identifier: MIT
// Normals from a depth texture alone.
//
// Window depth runs straight over the screen on every plane, for any projection. So the two texels to
// each side foretell the depth at hand, and the side that does so better lies on the same surface: edges
// stay sharp, where plain differences would bend them.
//
// Where the steps that depth is stored in are not small against a texel, texels farther apart serve, as long as they
// foretell the depth to within those steps. Both sides do on a plane; there the way from one to the other leans half as
// much as that to either. [Wu 2020 - the choice by two texels a side]

#include "common/view_space.glsl"

// How far apart texels are at most, in texels. What allows for normals that lean keeps to neighbours and is quicker: it
// says WIDEST_NORMAL 1 before it includes this.
#ifndef WIDEST_NORMAL
#define WIDEST_NORMAL 64
#endif

// Depth error of a side that ends at the texture's edge: more than any other.
const highp float kNoSide = 2.0;

// How much the steps of the depth may make a normal lean, as a slope, before texels farther apart serve.
const highp float kLean = 0.02;

// What makes a normal lean that is rebuilt from neighbouring texels: steps of the view depth, over a texel's width.
// `stored` is as in viewStepOf.
highp float leanAt(highp vec2 size, highp vec2 stored, highp vec3 point)
{
    highp vec2 texels = viewSizeIn(size) * uvOfUnit(point);
    return viewStepOf(stored, point) * max(texels.x, texels.y);
}

// How many texels apart those are that a normal is rebuilt from: a power of two.
highp int strideFor(highp float lean)
{
    highp int stride = 1;
#if WIDEST_NORMAL > 1
    while (stride < WIDEST_NORMAL && lean > kLean * float(stride)) stride *= 2;
#endif
    return stride;
}

// How far above its own tangent plane a surface may come out `reach` away, where its normal leans by more than
// estimators take: kLean is within any bias.
highp float rebuiltRise(highp vec2 size, highp vec2 stored, highp vec3 point, highp vec3 normal, highp float reach)
{
    highp float lean = leanAt(size, stored, point);
    return 0.5 * reach * raySlope(point, normal) * max(lean / float(strideFor(lean)) - kLean, 0.0);
}

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
    return viewFromWindow(uvFromGuardBand(texel, size), stored);
}

// The way along `axis` on the texel's surface, of no certain length. `noise` is the error of a side that steps of
// the depth explain.
highp vec3 alongSurface(highp sampler2D depths, highp ivec2 texel, highp ivec2 axis, highp float here,
                        highp vec3 point, highp int stride, highp float noise)
{
    highp vec2 size = vec2(textureSize(depths, 0));
    highp ivec2 step;
    highp float behind;
    highp float ahead;
    highp float error_behind;
    highp float error_ahead;
#if WIDEST_NORMAL > 1
    for (; stride > 0; stride /= 2)
#endif
    {
        step = stride * axis;
        behind = depthNear(depths, texel - step);
        ahead = depthNear(depths, texel + step);
        error_behind = sideError(depths, texel, -step, here, behind);
        error_ahead = sideError(depths, texel, step, here, ahead);
#if WIDEST_NORMAL > 1
        if (min(error_behind, error_ahead) <= noise) break;
#endif
    }
    bool by_behind = error_behind < max(error_ahead, noise);
    bool by_ahead = !by_behind || error_ahead <= noise;
    highp vec3 from = by_behind ? pointOfTexel(size, texel - step, behind) : point;
    highp vec3 way = (by_ahead ? pointOfTexel(size, texel + step, ahead) : point) - from;
    return way / max(max(abs(way.x), max(abs(way.y), abs(way.z))), 1e-30);
}

// The unit normal in view space at the view's uv, towards the camera. `stored` is as in viewStepOf.
highp vec3 rebuiltNormal(highp sampler2D depths, highp vec2 stored, highp vec2 at)
{
    highp vec2 size = vec2(textureSize(depths, 0));
    highp ivec2 texel = texelInGuardBand(at, size);
    highp float here = texelFetch(depths, texel, 0).r;
    highp vec3 point = pointOfTexel(size, texel, here);
    highp int stride = strideFor(leanAt(size, stored, point));
    highp float noise = 2.0 * (stored.x + stored.y * here);
    highp vec3 normal = cross(alongSurface(depths, texel, ivec2(1, 0), here, point, stride, noise),
                              alongSurface(depths, texel, ivec2(0, 1), here, point, stride, noise));
    highp float length_squared = dot(normal, normal);
    return length_squared > 0.0 ? normal * inversesqrt(length_squared) : vec3(0.0, 0.0, 1.0);
}
