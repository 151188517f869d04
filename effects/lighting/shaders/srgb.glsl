// SPDX-License-Identifier: MIT
// The transfer curve of displays, sRGB. [IEC 1999]

mediump vec3 srgbFromLinear(mediump vec3 color)
{
    mediump vec3 safe = clamp(color, 0.0, 1.0);
    mediump vec3 curve = 1.055 * pow(max(safe, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, safe * 12.92, lessThanEqual(safe, vec3(0.0031308)));
}
