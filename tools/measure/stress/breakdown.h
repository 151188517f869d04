// SPDX-License-Identifier: MIT
// Breakdown points as sentences, those that most users meet first.
#pragma once

#include "tools/measure/stress/run.h"

#include <string>
#include <vector>

namespace crevice {

/// Where a config breaks; cases that tell the same are one point, told by the one that breaks
/// first.
struct BreakdownPoint {
    std::string config;
    const StressCase* stress = nullptr;
    std::string format;
    const StressRecord* before = nullptr;  ///< The last step that holds; null: none.
    const StressRecord* after = nullptr;   ///< The first that fails.
    int steps_off = 0;                     ///< From the ordinary step to `after`.

    std::string effect;     ///< "is lost"
    std::string condition;  ///< "where the radius is taller than 0.7 screens"
    std::string held;       ///< The figures of the two steps, "0.7" and "1.4".
    std::string broke;
    std::string why;                  ///< "3 % of the ground truth's occlusion"
    std::vector<std::string> others;  ///< "`zoom` at 2.1"

    Likelihood likelihood = Likelihood::few;
    std::string because;
};

/// Of each config those that more users meet come first, and of them those that fewer steps lead to
/// from the ordinary one. Configs are in the order of `all`, whose records must outlive them.
std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all);

/// "AO of `gtao` is lost where the radius is taller than 0.7 screens: at 1.4, 3 % of the ground
/// truth's occlusion (a corner of a room walked up to; also `zoom` at 2.1)."
std::string sentenceOf(const BreakdownPoint& point);

/// "Every application meets it: cameras walk up to walls."
std::string likelihoodOf(const BreakdownPoint& point);

/// "every application", ...
std::string nameOf(Likelihood likelihood);

}  // namespace crevice
