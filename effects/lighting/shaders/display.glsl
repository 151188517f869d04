// SPDX-License-Identifier: MIT
// From linear light to what a display shows.
//
//   TONE_MAPPING  none cuts off what is above 1; neutral keeps colours as they are up to 0.8 and rolls off from there
//
// [IEC 1999 - sRGB; Hurlburt 2024 - neutral]

uniform float exposure;

vec3 toneMapped(vec3 color)
{
#if TONE_MAPPING == TONE_MAPPING_NEUTRAL
    const float kFrom = 0.8 - 0.04;
    const float kDesaturation = 0.15;
    float least = min(color.r, min(color.g, color.b));
    color -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < kFrom) return color;
    float rolled = 1.0 - (1.0 - kFrom) * (1.0 - kFrom) / (peak + 1.0 - 2.0 * kFrom);
    float grey = 1.0 - 1.0 / (kDesaturation * (peak - rolled) + 1.0);
    return mix(color * (rolled / peak), vec3(rolled), grey);
#else
    return color;
#endif
}

mediump vec3 srgbFromLinear(mediump vec3 color)
{
    mediump vec3 safe = clamp(color, 0.0, 1.0);
    mediump vec3 curve = 1.055 * pow(max(safe, 0.0031308), vec3(1.0 / 2.4)) - 0.055;
    return mix(curve, safe * 12.92, lessThanEqual(safe, vec3(0.0031308)));
}

mediump vec3 displayed(vec3 light)
{
    return srgbFromLinear(toneMapped(light * exposure));
}
