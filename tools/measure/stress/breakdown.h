// SPDX-License-Identifier: MIT
// Breakdown points as sentences.
#pragma once

#include "tools/measure/stress/run.h"

namespace crevice {

/// Where a config breaks; of cases that break by the same effect under the same condition the one
/// that breaks first.
struct BreakdownPoint {
    std::string config;
    const StressCase* stress = nullptr;
    const StressRecord* after = nullptr;  ///< The first step that fails.
    std::string effect;                   ///< "is lost"
    std::string condition;                ///< "where the radius is taller than 0.7 screens"
    std::string held;   ///< The figures of the last step that holds and of `after`: "0.7" and
    std::string broke;  ///< ... "1.4"; empty where the ordinary step fails.
    std::string why;    ///< "3 % of the ground truth's occlusion"
};

/// In the order of `all`, whose records must outlive them.
std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all);

/// "AO of `gtao` is lost where the radius is taller than 0.7 screens: at 1.4, 3 % of the ground
/// truth's occlusion."
std::string sentenceOf(const BreakdownPoint& point);

}  // namespace crevice
