// SPDX-License-Identifier: MIT
// What a picture of a stress case shows, in figures.
#pragma once

#include "tools/stress/record.h"

namespace crevice {

/// Mean, least and most of the finite pixels; adds those outside [0, 1] to what is out of range.
void describeOcclusion(const Image& ao, StressRecord& record);

/// What the format makes of the surface, and the pixels of the middle where that is fine enough.
void describeSurface(const Image& ao, const StressShot& shot, Format format, StressRecord& record);

/// The mean absolute change over what both pictures show; where that is not a number in one, 1.
/// Where pixels are spoiled, the largest change farther away.
double changeBetween(const Image& ordinary, const Image& image, const StressShot& shot);

/// Error and occlusion against the ground truth, over the pixels that it has.
void describeError(const Image& ao, const Image& ground_truth, StressRecord& record);

/// Of the shot's radius, at what is seen in the middle.
double radiusInPixels(const StressShot& shot);

}  // namespace crevice
