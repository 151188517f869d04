// SPDX-License-Identifier: MIT
// How far one image is from another: the figures that every report uses.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/image.h>

namespace crevice {

/// Figures over the first channel of the pixels that count. All are 0 when no pixel does.
struct ImageDifference {
    double rmse = 0;  ///< Root mean square of (test - ground truth).
    double bias = 0;  ///< Mean of (test - ground truth): above 0 is too bright.
    double p99 = 0;   ///< 99th percentile of the absolute error.
    double max = 0;   ///< Largest absolute error.
    /// What of the error repeats every 2 to 8 pixels or so: beads, teeth, bands, blotches. rms of
    /// the first channel's mean error over 3x3 pixels less that over 9x9.
    double pattern = 0;
    double rmse_fit = 0;   ///< Least rmse of (test^p - ground truth), negative tests counting as 0.
    double power_fit = 1;  ///< That p, in [0.1, 10]: contrast, distinguished from shape.
    double psnr_db = 0;    ///< 20 log10(1 / rmse); infinite for equal images.
    double bad_fraction = 0;   ///< Pixels whose absolute error is above the threshold, [0, 1].
    long long pixels = 0;      ///< Pixels that count.
    long long masked = 0;      ///< Pixels where the ground truth is not finite or the mask is 0.
    long long non_finite = 0;  ///< Further pixels where the test is not finite; always a fault.
};

/// Compares channel by channel: a pixel of n channels counts n times, and the least number of
/// channels of both images is used. With a `mask` only pixels count where any of its colours is
/// above 0. Without `fit` there are no rmse_fit, power_fit and pattern, which take most of the
/// time.
///
/// Errors: CV7006 when the sizes differ, CV7005 for images without pixels.
Result<ImageDifference> compareImages(const Image& test, const Image& ground_truth,
                                      const Image* mask = nullptr, double threshold = 0.05,
                                      bool fit = true);

/// (test - ground truth) of the first channel as a picture: white is equal, blue is darker than the
/// ground truth, red is brighter, full colour at `range`; masked pixels are grey, broken ones
/// magenta.
///
/// Errors: as `compareImages`.
Result<Image> differencePicture(const Image& test, const Image& ground_truth,
                                const Image* mask = nullptr, double range = 0.25);

/// With so many channels: the first ones, or 1 for those that it has not.
Image withChannels(const Image& image, int channels);

// --- flip.cpp: how different two pictures look to somebody who flips between them, from 0 to 1 ---
//
// Source: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images".

/// Pixels that a degree of the eye's view covers: a screen of 0.7 m and 3840 pixels seen from 0.7 m
/// away.
constexpr double kFlipPixelsPerDegree = 67;

/// The mean over all pixels. Values are sRGB in [0, 1], others are clamped; a picture of fewer than
/// three channels is grey. Requires finite pixels and one size. Symmetric in its pictures.
double meanFlip(const Image& test, const Image& reference,
                double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace crevice
