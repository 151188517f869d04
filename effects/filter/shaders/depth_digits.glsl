// SPDX-License-Identifier: MIT
// View z in the three digits of an 8-bit colour, and back. Finest near the camera: a thousandth of a radius at a
// hundred of them away, a tenth at a thousand, where a radius is less than a pixel. The curve, 1 / (1 + radii), is ours.
// [Pranckevicius 2009, "Encoding Floats to RGBA - the Final?" - the digits]

uniform highp float radius;

const highp vec3 kDigits = vec3(1.0, 255.0, 65025.0);  // 24 bits of a number in three of 8

highp vec3 digitsOf(highp float z)
{
    highp float radii = z / max(radius, 1e-30);
    highp float far = 0.5 / (1.0 + abs(radii));
    highp vec3 digits = fract(min(radii > 0.0 ? 1.0 - far : far, 0.9999999) * kDigits);
    return digits - vec3(digits.yz / 255.0, 0.0);
}

highp float zOf(highp vec3 digits)
{
    highp float place = dot(digits, 1.0 / kDigits);
    highp float far = max(min(place, 1.0 - place), 1e-8);
    return sign(place - 0.5) * (0.5 / far - 1.0) * radius;
}
