// SPDX-License-Identifier: MIT
// Whether configs cost more than the costs that were approved.
#pragma once

#include "tools/measure/cost/cost.h"

namespace crevice {

/// By how much a sum may grow: what the smallest changes of a shader do to a compiler's choices.
constexpr double kCostGrowth = 0.10;

struct ApprovedCost {
    CostReport report;
    CostOptions options;  ///< Under which it is measured again.
};

/// Reads what costJson wrote. The options become those of the text where it has them, so that
/// nothing but the shaders can differ. Errors: CV7009 for a text that holds no costs.
Result<ApprovedCost> readCost(const std::string& name, const std::string& text,
                              const CostOptions& options);

struct CostComparison {
    std::vector<std::string> worse;   ///< One sentence each: where, what was, what is.
    std::vector<std::string> better;  ///< Less than 1 / (1 + kCostGrowth).
};

/// Of each config's AO, with all that is drawn for it: worse is more than kCostGrowth more fetches
/// or, on any GPU, instructions, cycles, spills or fills; lower occupancy; and a refused pass.
/// Requires reports of the same configs and GPUs, as ApprovedCost::options gives them.
Result<CostComparison> compareCosts(const CostReport& approved, const CostReport& now);

}  // namespace crevice
