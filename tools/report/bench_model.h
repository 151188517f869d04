// SPDX-License-Identifier: MIT
// What a report says, as JSON: what bench.js reads and `crevice report` writes beside the page.
//
//     points    every point as in the results, with its label
//     views     what is held against each other: points, Pareto fronts over cost in ms and over the
//               floor, the error without AO, curves; `main` where it is its scene's first
//     advice    for each device, which configs to take over all of its scenes, by rising cost, and
//               which do more harm than good
//     failures  what has no figures, and why
//     ablation  the rows of tools/bench/ablation.h, added by tools/report/bench_report.cpp
//
// Points are named by their index in `points`.
#pragma once

#include "tools/bench/sample.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace crevice {

nlohmann::json reportModel(const std::vector<BenchPoint>& points);

}  // namespace crevice
