// SPDX-License-Identifier: MIT
// Every limit that a step of a stress case is judged by, and why it is that. None is fitted to what
// a config does; docs/reference/stress.md explains them.
#pragma once

namespace crevice {

// --- what must be there ---

/// A plane's mean: a quarter of a step of 8 bits off open.
constexpr double kOpenMean = 0.999;

/// The least pixel in the middle of a plane: one that a filter over 4x4 pixels spreads to less than
/// a step of 8 bits.
constexpr float kOpenPixel = 0.95f;

/// Mean change of what must be the same: half a step of 8 bits, the most that rounding changes.
constexpr double kSameChange = 0.002;

/// Largest change of one pixel that must be the same: one step of 8 bits, 1/255.
constexpr double kSamePixel = 0.004;

/// Mean distance of ambient light, in 32-bit floats, from what it must be: half a step of the half
/// floats that phones compute colours in.
constexpr double kSameLight = 0.00025;

// --- what must not be lost ---

/// Occlusion of the ordinary picture over that of the ground truth. A picture of half the occlusion
/// must fail even where the estimator is itself a third too dark: 4/3 * 1/2. The upper one is as
/// far off as a factor.
constexpr double kLeastStrength = 2.0 / 3.0;
constexpr double kMostStrength = 3.0 / 2.0;

/// Share of the exact answer's occlusion that every other step keeps: what lost more than half is
/// closer to no ambient occlusion than to the right one.
constexpr double kLeastKept = 0.5;

/// ... and the most that it makes of it: as far off, as a factor.
constexpr double kMostKept = 2.0;

/// Share of the pixels that may differ from one frame of a still camera to the next, by more than
/// kSameChange allows two pictures together: 2/255. One in a thousand is 37 pixels of 256x144,
/// which nobody sees.
constexpr double kRestlessShare = 0.001;
constexpr double kRestlessPixel = 2.0 / 255.0;

/// Mean occlusion from which the exact answer counts as occlusion: half of it is more than twice
/// kSameChange.
constexpr double kLeastExact = 0.01;

/// Pixels. A smaller radius lies within the neighbours of a pixel, and a smaller picture shows
/// nothing that could occlude.
constexpr double kLeastRadiusPx = 2;
constexpr int kLeastSide = 16;

// --- what a format resolves ---
// A step of the format raises a horizon at half the radius by twice the step, in radii. All around,
// that takes the squared sine of the angle from an open surface [Jimenez et al. 2016].

/// Steps, in radii, that nobody sees: sin^2(2 * 0.02) = 0.0016 is below kSameChange.
constexpr double kFineShare = 0.02;

/// Past that a picture may change by the squared sine of this many steps: of both the point and
/// what occludes it.
constexpr double kRaises = 4;

/// Steps that leave planes open: sin^2(2 * 0.1) = 0.04 is below 1 - kOpenPixel.
constexpr double kOpenShare = 0.1;

}  // namespace crevice
