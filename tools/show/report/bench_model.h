// SPDX-License-Identifier: MIT
// What a report says, as JSON: what bench.js reads and `crevice report` writes beside the page.
//
//     bench_samples  every bench sample as in the results, with its label
//     views          what can be compared: bench samples, Pareto fronts over cost in ms and over
//                    the copy cost, the error without AO, curves; `main` where it is its scene's
//                    first
//     advice         for each device, which configs to take over all of its scenes, by rising cost,
//                    and which do more harm than good
//     failures       what has no figures, and why
//
// Bench samples are named by their index in `bench_samples`.
#pragma once

#include "tools/measure/bench/sample.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace crevice {

nlohmann::json reportModel(const std::vector<BenchSample>& samples);

}  // namespace crevice
