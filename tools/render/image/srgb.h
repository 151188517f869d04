// SPDX-License-Identifier: MIT
// Colours of image files as light.
#pragma once

#include <cmath>

namespace crevice {

/// [IEC 1999]; both in [0, 1].
inline float linearFromSrgb(float value)
{
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

}  // namespace crevice
