// SPDX-License-Identifier: MIT
// The error budget: by how much the error of a config changes when one thing about it is made
// ideal, found by drawing it so.
#pragma once

#include "tools/measure/bench/error_parts.h"
#include "tools/measure/bench/sample.h"

#include <crevice/renderer.h>

#include <functional>

namespace crevice {

/// Most frames that are averaged into a converged picture.
constexpr int kMostConvergedFrames = 64;

/// A converged picture is done when what noise is left in it is less, as an rmse. It adds to an
/// error as the root of the sum of squares: 3 % to one of 0.016, 0.3 % to one of 0.05.
constexpr double kConvergedNoise = 0.004;

/// Where frames are drawn, and the scene's frame.
struct Stage {
    Device& device;
    const Frame& frame;
    Extent extent;
    const SourceSet& sources;  ///< Have the module that kIdealLayers lays over a config.
};

/// The output `ao` of the config with some things made ideal, `ideal` being bits of `Ideal`.
///
/// With kIdealTaps it is the mean over frames with other seeds in every generated kernel and noise
/// than the config's own; a mean over frames, of which nothing is left to gather, is then drawn
/// once. With kIdealScreen and no guard band, the camera sees half a view more on each side, which
/// is cut off.
///
/// Stops early, with what it has, when `interrupted`. Errors: those of Renderer::create,
/// Renderer::render and Device::readTexture.
Result<Image> idealOcclusion(const Stage& stage, Description description, unsigned ideal,
                             const std::function<bool()>& interrupted);

/// The budget of a config whose own error is `rmse`. `errorOf` gives the error with some things
/// made ideal, or why it is not known; the first such reason goes to `failure`.
ErrorBudget budgetOf(double rmse, const std::function<Result<double>(unsigned ideal)>& errorOf,
                     std::string& failure);

}  // namespace crevice
