// SPDX-License-Identifier: MIT
// The error budget: how much of a config's error more samples, another estimator and wider formats
// would take away.
#pragma once

#include "tools/bench/sample.h"

#include <crevice/renderer.h>

#include <functional>

namespace crevice {

/// Most frames that are averaged into a converged picture.
constexpr int kMostConvergedFrames = 64;

/// A converged picture is done when what noise is left in it is less, as an rmse.
constexpr double kConvergedNoise = 0.002;

/// Where frames are drawn.
struct Stage {
    Device& device;
    const Frame& frame;
    Extent extent;
};

/// One output of a config, as drawSettled draws it.
/// Errors: those of Renderer::create, Renderer::render and Device::readTexture.
Result<Image> drawOutput(const Stage& stage, Description description, const std::string& output);

/// The config with all the depth taps that its ranges allow and 32-bit float for its occlusion,
/// averaged over frames with other seeds in every generated kernel and noise than the config's own.
/// What is averaged is the target `ao`, before any filter; the output `ao` where there is no such
/// target or it is not of full size.
///
/// Stops early, with what it has, when `interrupted`. Errors: as drawOutput.
Result<Image> convergedOcclusion(const Stage& stage, const Description& description,
                                 const std::function<bool()>& interrupted);

/// One frame of the config as it is, of the same target: what its filter gets.
/// Errors: as drawOutput.
Result<Image> unfilteredOcclusion(const Stage& stage, const Description& description);

/// The output `ao` with every target in the 32-bit float format of as many channels, or depth32f.
/// Errors: as drawOutput.
Result<Image> preciseOcclusion(const Stage& stage, const Description& description);

/// The pictures of one config that its error budget compares. One without pixels, or of another
/// size, leaves its part at -1.
struct BudgetPictures {
    const Image& ao;
    const Image& ground_truth;
    const Image& converged;
    const Image& unfiltered;
    const Image& precise;
};

/// The parts over the pixels where the ground truth is finite.
ErrorBudget budgetOf(const BudgetPictures& pictures);

}  // namespace crevice
