// SPDX-License-Identifier: MIT
// Bench points with plausible figures, for tests of what reads them.
#pragma once

#include "tools/bench/sample.h"

#include <string>

namespace crevice {

/// A point of "room" at 960x540 and radius 1 on one device; its key says which it is. `ms` is its
/// cost.
inline BenchPoint benchPoint(const std::string& config, int samples, double ms, double rmse,
                             const std::string& scene = "room")
{
    BenchPoint point;
    point.key = config + std::to_string(samples) + scene;
    point.config = config;
    point.overrides = {"radius=1", "samples=" + std::to_string(samples)};
    point.family = config;
    point.scene = scene;
    point.extent = {960, 540};
    point.radius = 1;
    point.rays = 256;
    point.radius_px = 80;
    point.samples = samples;
    point.triangles = 1000;
    point.device = "device A";
    point.version = "1.0";
    point.error.rmse = point.error.rmse_fit = rmse;
    point.error.bias = -rmse / 2;
    point.error.p99 = 3 * rmse;
    point.error.pixels = 500000;
    point.error_without_ao = 0.35;
    point.budget = {rmse, rmse / 2, rmse * 0.8, 0.001};
    point.clock = "query";
    point.repeats = 9;
    point.total = {2 * ms, ms * 1.8, ms * 2.2};
    point.cost = {ms, ms * 0.9, ms * 1.1};
    point.passes = {{"geometry", {ms, ms, ms}}, {"ao", {ms, ms, ms}}};
    point.ratio_copy = ms * 10;
    point.ratio_learnopengl = ms / 4;
    return point;
}

}  // namespace crevice
