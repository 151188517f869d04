// SPDX-License-Identifier: MIT
// How high over a surface something stands within a slice, as a lift, and the light below it.
//
// A lift is 0 along the surface and 1 along the normal, in between the sine of the angle over the surface; beyond the
// normal, towards the camera, it goes on to 2 less that sine. Of the light that a cosine-weighted hemisphere gets, an
// angle t from the camera brings cos(t - n) sin t dt, where n is the angle of the normal within the slice.
//
// [Jimenez et al. 2016] Lines are those of its algorithm 1, as XeGTAO counts them.

#include "common/angles.glsl"

// The lift of a unit direction within the slice, from its components along the surface's normal and towards the camera.
// The normal leans towards the direction's side by the angle n.
mediump float liftOf(mediump float height, mediump float towards, mediump float cos_n, mediump float sin_n)
{
    mediump float up = clamp(height, 0.0, 1.0);
    bool beyond = sin_n > 0.0 && towards > cos_n;
    if (beyond) up = up > cos_n ? 2.0 - up : 0.0;
    return up;
}

// asin(u) - u sqrt(1 - u^2) of u in 0..1, to within 7e-5.
mediump float liftIntegral(mediump float u)
{
    return 1.5707963 - angleOf(u) - u * sqrt(max(1.0 - u * u, 0.0));
}

// The light below a lift on a side towards which the normal leans by the angle n: line 27, from the surface up.
mediump float lightBelow(mediump float lift, mediump float cos_n, mediump float sin_n)
{
    mediump float u = min(lift, 2.0 - lift);
    mediump float across = liftIntegral(u);
    return 0.5 * (cos_n * u * u + sin_n * (lift > 1.0 ? 3.1415927 - across : across));
}
