// SPDX-License-Identifier: MIT
// The hemisphere over a point, cut into slices by planes through the view ray, and each slice into two
// sides, along which the screen is marched.
//
// An angle on a side counts from the direction to the camera and is given by its cosine. Of the light that
// a cosine-weighted hemisphere gets, angle t of a side brings cos(t - n) sin t dt, where n is the angle
// of the normal within the slice; `cosineArcIntegral` is its integral.
//
// [Jimenez et al. 2016, "Practical Realtime Strategies for Accurate Indirect Occlusion"]. Lines are those of its
// algorithm 1, as XeGTAO counts them.

#include "common/angles.glsl"

struct Side {
    highp float cos_n;  // of the normal's angle, positive towards this side
    highp float sin_n;
    highp float projected_length;  // of the normal, projected onto the slice: a rise over the surface shrinks by it
    highp float whole;  // the light of all of the side
};

// Cosine of the angle at which the surface's own plane ends the side.
highp float lastCosine(Side side)
{
    return -side.sin_n;
}

// The light from angle 0 up to that of cosine `c`, at most up to the end of the side. Line 27: with t the angle,
// (cos n - cos(2 t - n) + 2 t sin n) / 4, here without sines of sums.
highp float cosineArcIntegral(Side side, highp float c)
{
    highp float kept = clamp(c, lastCosine(side), 1.0);
    highp float s = sqrt(max(1.0 - kept * kept, 0.0));
    return 0.5 * (s * s * side.cos_n + (angleOf(kept) - s * kept) * side.sin_n);
}

// The light's direction up to the angle of cosine `c`, not normalised: towards the camera, and along the
// side. The paper's algorithm 2, one side of it, here as powers of sine and cosine.
highp vec2 openDirection(Side side, highp float c)
{
    highp float s = sqrt(max(1.0 - c * c, 0.0));
    highp float c3 = c * c * c;
    highp float s3 = s * s * s;
    return vec2(side.cos_n * (1.0 - c3) + side.sin_n * s3,
                side.cos_n * s3 + side.sin_n * (2.0 - 3.0 * c + c3)) / 3.0;
}

// How far up on a side something lies: 0 on the surface and where it lies on the other side of the camera, 1 along the
// normal, above 1 beyond the normal, towards the camera. `rise` is the cosine between its direction and the normal,
// `leads` whether it lies on this side of the normal.
//
// A texel's centre lies somewhat off the slice. On a surface at a grazing angle, its angle to the camera may then
// place it high above that surface, and its rise does not. Ours: planes are open at every angle. The paper takes the
// angle to the camera, lines 23 and 24.
highp float liftOf(Side side, highp float rise, bool leads)
{
    highp float up = clamp(rise / side.projected_length, 0.0, 1.0);
    if (leads) return up;
    bool before_camera = side.sin_n > 0.0 && up > side.cos_n;
    return before_camera ? 2.0 - up : 0.0;
}

// Cosine of the angle of what lies so far up.
highp float cosineOfLift(Side side, highp float lift)
{
    highp float up = min(lift, 2.0 - lift);
    highp float level = sqrt(1.0 - up * up);
    return side.cos_n * up + side.sin_n * (lift > 1.0 ? level : -level);
}

// `sin_n` is positive where the normal leans towards this side.
Side sideOf(highp float cos_n, highp float sin_n, highp float projected_length)
{
    Side side = Side(cos_n, sin_n, projected_length, 0.0);
    side.whole = cosineArcIntegral(side, -1.0);
    return side;
}
