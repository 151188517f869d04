// SPDX-License-Identifier: MIT
// Colours of image files as light.
#pragma once

#include <cmath>
#include <vector>

namespace crevice {

/// [IEC 1999]; both in [0, 1].
inline float linearFromSrgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

/// The same, faster where `value` is a whole number over 65535, as in pictures of 8 and 16 bits.
inline float pictureLinearFromSrgb(float value)
{
    constexpr int kSteps = 65535;
    static const std::vector<float> known = [] {
        std::vector<float> all(kSteps + 1);
        for (int k = 0; k <= kSteps; ++k) all[std::size_t(k)] = linearFromSrgb(float(k) / kSteps);
        return all;
    }();
    const float step = value * kSteps;
    const auto index = static_cast<std::size_t>(step >= 0 && step <= kSteps ? step + 0.5f : 0);
    return float(index) / kSteps == value ? known[index] : linearFromSrgb(value);
}

}  // namespace crevice
