// SPDX-License-Identifier: MIT
// View depth as a share in 0..1: 1 at the camera, falling with distance, 0 in the background.
//
// At distance D it is U / (U + D), of a unit U that is the radius, or less where that is far wider than what the camera
// can come near to. So it is the same for any projection and format of depth, is finest near the camera, and runs
// almost straight over the screen on a plane. Ours. Of 24 bits a step at 100 radii is 0.0006 radii.

#include "common/view_space.glsl"

uniform highp float radius;

// Above 0, so that one can divide by it.
highp float usedRadius() { return max(radius, 1e-30); }

highp float depthUnit()
{
#if CAMERA_ORTHOGRAPHIC
    highp float widest = 1.0 / max(abs(clip_from_view[1][1]), 1e-30);
#else
#if CAMERA_REVERSED_DEPTH
    highp vec4 near = view_from_window[2] + view_from_window[3];
#else
    highp vec4 near = view_from_window[3];
#endif
    highp float widest = 1e3 * abs(near.z / near.w);
#endif
    return max(min(radius, widest), 1e-30);
}

// Of what was drawn more than 0, also infinitely far away.
const highp float kFarthestShare = 2.0 / 16777215.0;

// `z` and `unit` in the same length. A parallel view may begin behind the camera: there the share goes on from 0.5 to 1.
highp float shareOfZ(highp float z, highp float unit)
{
#if CAMERA_ORTHOGRAPHIC
    highp float half_share = 0.5 * unit / (unit + abs(z));
    return max(z > 0.0 ? 1.0 - half_share : half_share, kFarthestShare);
#else
    return clamp(unit / (unit - z), kFarthestShare, 1.0);
#endif
}

// Of a share above 0.
highp float zOfShare(highp float share, highp float unit)
{
#if CAMERA_ORTHOGRAPHIC
    highp float distance = 0.5 * unit / min(share, 1.0 - share) - unit;
    return share > 0.5 ? distance : -distance;
#else
    return unit - unit / share;
#endif
}

// How far apart in view depth two neighbouring values of 24 bits are.
highp float shareStep(highp float share)
{
    highp float kept = max(share, kFarthestShare);
#if CAMERA_ORTHOGRAPHIC
    kept = min(kept, 1.0 - kept) * 1.41421356;
#endif
    return depthUnit() / (kept * kept) / 16777215.0;
}

// In the three digits of an 8-bit colour, and back. [Pranckevicius 2009 - the digits]
const highp vec3 kDigits = vec3(1.0, 255.0, 65025.0);

highp vec3 digitsOfShare(highp float share)
{
    highp vec3 digits = fract(min(share, 0.9999999) * kDigits);
    return digits - vec3(digits.yz / 255.0, 0.0);
}

highp float shareOfDigits(highp vec3 digits)
{
    return dot(digits, 1.0 / kDigits);
}

// The same with a mark in the last bit, and whether it is there.
highp vec3 markedDigits(highp float share, bool mark)
{
    highp vec3 digits = digitsOfShare(share);
    digits.z = (2.0 * floor(127.0 * digits.z + 0.5) + (mark ? 1.0 : 0.0)) / 255.0;
    return digits;
}

bool isMarked(highp vec3 digits) { return fract(127.5 * digits.z + 0.25) > 0.5; }
