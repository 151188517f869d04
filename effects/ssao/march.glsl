// SPDX-License-Identifier: MIT
// What the estimators that march over the screen share: the pixel's slices and where their taps lie.

#include "common/pixel_noise.glsl"
#include "ssao/reach.glsl"
#include "ssao/slice.glsl"

uniform highp float bias;

const highp float kPi = 3.14159265;

// The slices of one pixel.
struct March {
    highp vec3 point;      // view space, lifted off its own surface
    highp vec3 normal;
    highp vec3 to_camera;  // unit
    highp vec2 uv;
    highp vec2 reach;      // one radius across the screen, in uv
    highp vec2 pixel;      // one pixel, in uv
    highp vec2 noise;      // 0..1: turns the slices, shifts the taps
};

// `at` counts pixels, `pixel` is one of them in uv.
March marchFrom(highp vec2 uv, highp vec2 at, highp vec2 pixel, highp vec3 point, highp vec3 normal)
{
    March march;
    march.normal = normal;
#if CAMERA_ORTHOGRAPHIC
    march.to_camera = vec3(0.0, 0.0, 1.0);
#else
    march.to_camera = -normalize(point);
#endif
    march.point = point + normal * (bias * radius);
    march.uv = uv;
    march.reach = reachOf(point);
    march.pixel = pixel;
    march.noise = pixelNoise(at);
    return march;
}

// A slice through the hemisphere.
struct Slice {
    highp vec2 direction;  // across the screen, a unit vector
    highp vec3 along;      // the same in view space, perpendicular to the direction to the camera
    highp vec3 turn;       // cosine and sine of the normal's angle in it, and how much of the normal lies in it
};

// Slices lie evenly over half a turn.
Slice sliceOf(March march, int index)
{
    highp float angle = kPi * (float(index) + march.noise.x) / float(SLICES);
    highp vec2 direction = vec2(cos(angle), sin(angle));
    highp vec3 across = vec3(direction, 0.0);
    highp vec3 along = normalize(across - march.to_camera * dot(across, march.to_camera));
    highp vec2 turn = vec2(dot(march.normal, march.to_camera), dot(march.normal, along));
    highp float size = length(turn);
    return Slice(direction, along, size > 1e-3 ? vec3(turn / size, size) : vec3(1.0, 0.0, 1e-3));
}

// On the surface, away from the point; perpendicular to the normal within the slice.
highp vec3 outward(March march, Slice slice, highp float sign)
{
    return sign * (slice.along * slice.turn.x - march.to_camera * slice.turn.y);
}

// Cosine of the angle of an offset from the point.
highp float cosineOf(March march, Side side, highp vec3 outwards, highp vec3 offset)
{
    highp float rise = dot(offset, march.normal) * inversesqrt(max(dot(offset, offset), 1e-30));
    return cosineOfRise(side, rise, dot(offset, outwards) >= 0.0);
}

highp float shareShown(March march)
{
    return shareShown(march.reach, march.pixel);
}

// Whether the surface at the uv of a tap is known, and its offset from the point.
bool offsetAt(March march, highp vec2 at, out highp vec3 offset)
{
    highp vec3 seen;
    bool known = isCaptured(at) && pointAt(at, seen);
    offset = seen - march.point;
    return known;
}

// Where tap `i` of a side lies: evenly from the pixel to somewhat beyond the radius, so that the surface
// is seen to leave it. A tap is at least a pixel away.
highp vec2 tapAt(March march, Slice slice, highp float sign, int i)
{
    highp float shift = fract(march.noise.y + 0.25 * (1.0 - sign));
    highp float share = (float(i) + shift) / (float(STEPS) - 0.5);
    highp vec2 offset = slice.direction * march.reach * share;
    highp float pixels = length(offset / march.pixel);
    return march.uv + sign * (pixels < 1.0 ? slice.direction * march.pixel : offset);
}
