// SPDX-License-Identifier: MIT
// What an edit does to a stress run, by the run before it.
#pragma once

#include "tools/measure/stress/run.h"

#include <string>
#include <vector>

namespace crevice {

/// A step that is not as it was.
struct StressDifference {
    std::string step;  ///< "gtao, off_centre, 64"
    std::string what;  ///< "breaks: mean change 0.003", "mean 0.93, was 0.91"
};

/// Steps of `now` that have another outcome than in `before`, or of which the mean, the error or
/// the change moved by more than what must be the same may (kSameChange). Steps that `before` lacks
/// count in `missing`.
std::vector<StressDifference> differencesSince(const std::vector<StressSeries>& before,
                                               const std::vector<StressSeries>& now,
                                               std::size_t& missing);

}  // namespace crevice
