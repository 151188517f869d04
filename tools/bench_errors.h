// SPDX-License-Identifier: MIT
// The error budget: how much of a config's error more samples, another estimator and wider formats
// would take away.
#pragma once

#include "tools/bench_point.h"

#include "core/renderer.h"

#include <functional>

namespace crevice {

/// Most frames that are averaged into a converged picture.
constexpr int kMostConvergedFrames = 64;

/// A converged picture is done when one more frame changes it by less, as an rmse.
constexpr double kConvergedChange = 0.001;

/// Where frames are drawn.
struct Stage {
    Device& device;
    const Frame& frame;
    Extent extent;
};

/// One frame of one output of a config.
/// Errors: those of Renderer::create, Renderer::render and Device::readTexture.
Result<Image> drawOutput(const Stage& stage, Description description, const std::string& output);

/// The config with the param `samples` at its largest and 32-bit float for its occlusion, averaged
/// over frames with other seeds in every generated kernel and noise. What is averaged is the target
/// `ao`, before any filter; the output `ao` where there is no such target or it is not of full size.
///
/// Stops early, with what it has, when `interrupted`. Errors: as drawOutput.
Result<Image> convergedOcclusion(const Stage& stage, const Description& description,
                                 const std::function<bool()>& interrupted);

/// The output `ao` with every target in the 32-bit float format of as many channels, or depth32f.
/// Errors: as drawOutput.
Result<Image> preciseOcclusion(const Stage& stage, const Description& description);

/// The three parts over the pixels where `truth` is finite. An image without pixels, or of another
/// size, leaves -1.
ErrorBudget budgetOf(const Image& ao, const Image& truth, const Image& converged,
                     const Image& precise);

/// A length in pixels at the median depth of what is seen: radius * clip_from_view[1][1] * height / (2
/// w), where w is the view distance in a perspective and 1 in an orthographic view. `depth` holds
/// window depths, 1 in the background; 0 when nothing is seen.
double radiusOnScreen(double radius, const Camera& camera, const Image& depth);

}  // namespace crevice
