// SPDX-License-Identifier: MIT
// FLIP: how different two pictures look to somebody who flips between them, from 0 to 1.
//
// Source: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images".
#pragma once

#include <crevice/image.h>

namespace crevice {

/// Pixels that a degree of the eye's view covers: a screen of 0.7 m and 3840 pixels seen from 0.7 m
/// away.
constexpr double kFlipPixelsPerDegree = 67;

/// The mean over all pixels. Values are sRGB in [0, 1], others are clamped; a picture of fewer than
/// three channels is grey. Requires finite pixels and one size. Symmetric in its pictures.
double meanFlip(const Image& test, const Image& reference,
                double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace crevice
