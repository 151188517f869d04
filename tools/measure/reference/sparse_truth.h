// SPDX-License-Identifier: MIT
// The ground truth at some pixels of a view, evenly spread, and how wrong a picture is there.
//
// An error is a mean over pixels, so some thousands of them tell it to a few per cent, and tracing
// takes a second. The same pixels serve every picture, so two are told apart far better than
// either is known.
//
// Source: Roberts 2018 - where the pixels lie.
#pragma once

#include "tools/measure/reference/pixel_tracer.h"

namespace crevice {

/// The standard deviations on either side that hold 95 %.
constexpr double kConfidence = 1.96;

struct TruePixel {
    int x = 0, y = 0;
    float visibility = 1.0f;
};

/// The scene must outlive it.
class SparseTruth {
public:
    /// Errors: those of checkTrace().
    static Result<SparseTruth> begin(const RayScene& scene, const Camera& camera, Extent extent,
                                     const TraceOptions& options);

    /// Traces on all processors until so many pixels that see a surface are known, or all of them
    /// are. What was known stays in its place. Errors: CV7008 when the camera sees no surface.
    Status grow(std::size_t pixels);

    const std::vector<TruePixel>& pixels() const { return pixels_; }

private:
    explicit SparseTruth(PixelTracer tracer) : tracer_(std::move(tracer)) {}

    PixelTracer tracer_;
    std::vector<TruePixel> pixels_;
    std::size_t tried_ = 0;
};

/// A picture's error over the pixels of a SparseTruth.
struct SparseError {
    double rmse = 0;
    double margin = 0;  ///< The rmse over all pixels is within this of `rmse` at 95 % confidence.
    double bias = 0;    ///< Mean of (picture - truth): below 0 is too dark.
    double without_ao = 0;       ///< The rmse of a white picture.
    double p99 = 0;              ///< 99th percentile of the absolute error.
    double dark = 0;             ///< Share of the squared error where the picture is too dark.
    std::vector<float> squares;  ///< Of each pixel's error, in the truth's order.
};

/// Errors: CV4003 for a picture that is no number somewhere. Requires a picture of the truth's
/// extent and a truth of at least one pixel.
Result<SparseError> sparseError(const Image& picture, const SparseTruth& truth);

/// By how many standard deviations of that gap the first's rmse is below `share` of the second's,
/// over the pixels that both have.
double deviationsBelow(const SparseError& less, const SparseError& more, double share = 1.0);

}  // namespace crevice
