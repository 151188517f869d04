// SPDX-License-Identifier: MIT
// Whether configs cost more than the costs that were approved.
#pragma once

#include "tools/measure/cost/cost.h"

#include <string>
#include <vector>

namespace crevice {

/// By how much a sum may grow: what the smallest changes of a shader do to a compiler's choices.
constexpr double kCostGrowth = 0.10;

struct CostComparison {
    std::vector<std::string> worse;   ///< One sentence each: where, what was, what is.
    std::vector<std::string> better;  ///< Grown less than 1 / (1 + kCostGrowth), or mended.
};

/// Worse is, on any GPU: an AO pass that spills where it did not, or of a new name in a config that
/// did not; lower occupancy likewise; a refused program; and of the config's AO, with all that is
/// drawn for it, more than kCostGrowth more instructions, cycles, spills and fills or fetches. And
/// a config that is missing now. What is only in `now` is not looked at.
CostComparison compareCosts(const CostReport& approved, const CostReport& now);

}  // namespace crevice
