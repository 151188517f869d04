// SPDX-License-Identifier: MIT
// How long a frame took, pass by pass.
#pragma once

#include <vector>

namespace crevice {

enum class TimingMethod {
    wall_clock,  ///< CPU and GPU together, waiting for the GPU after each pass: no two overlap.
    gpu_timer,   ///< The GPU alone, nothing waiting.
};

/// All in milliseconds. Compare only figures of one method.
struct FrameTimes {
    TimingMethod method = TimingMethod::wall_clock;

    /// In the order of the plan's passes, each with all views together. Negative where the GPU's
    /// timer gave no valid result.
    std::vector<double> pass_ms = {};

    /// By the clock: all of the frame, with what lies between the passes. By the GPU's timer: the
    /// sum of the passes, or -1 when one of them is void; then draw again.
    double total_ms = 0;
};

}  // namespace crevice
