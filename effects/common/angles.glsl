// SPDX-License-Identifier: MIT
// Angles, quickly.

// The angle in 0..pi whose cosine is `c`, in radians, to within 7e-5. [Abramowitz, Stegun 1964, 4.4.45]
highp float angleOf(highp float c)
{
    highp float x = abs(c);
    highp float angle = sqrt(max(1.0 - x, 0.0)) *
                        (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x)));
    return c < 0.0 ? 3.14159265 - angle : angle;
}
