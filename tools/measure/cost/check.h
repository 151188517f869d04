// SPDX-License-Identifier: MIT
// Whether configs cost more than the costs that were approved.
#pragma once

#include "tools/measure/cost/cost.h"

#include <string>
#include <vector>

namespace crevice {

/// By how much a sum may grow: what the smallest changes of a shader do to a compiler's choices.
constexpr double kCostGrowth = 0.10;

struct ApprovedCost {
    CostReport report;
    CostOptions options;  ///< Under which it is measured again.
};

/// Reads what costJson wrote. The options become those of the text where it has them, so that nothing
/// but the shaders can differ. Errors: CV7009 for a text that holds no costs.
Result<ApprovedCost> readCost(const std::string& name, const std::string& text,
                              const CostOptions& options);

struct CostComparison {
    std::vector<std::string> worse;   ///< One sentence each: where, what was, what is.
    std::vector<std::string> better;  ///< Less than 1 / (1 + kCostGrowth).
};

/// Worse is, on any GPU: an AO pass that spills or is refused where it was not, or, of a new name,
/// where no pass of its config was; lower occupancy likewise; and of the config's AO, with all that
/// is drawn for it, more than kCostGrowth more instructions, cycles, spills and fills or fetches.
/// Requires reports of the same configs and GPUs, as ApprovedCost::options gives them.
Result<CostComparison> compareCosts(const CostReport& approved, const CostReport& now);

}  // namespace crevice
