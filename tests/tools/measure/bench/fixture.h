// SPDX-License-Identifier: MIT
// Bench samples with plausible figures, for tests of what reads them.
#pragma once

#include "tools/measure/bench/sample.h"

namespace crevice {

/// A sample of "room" at 960x540 and radius 1 on one device; its key says which it is. `ms` is its
/// cost.
inline BenchSample benchSample(const std::string& config, int samples, double ms, double rmse,
                               const std::string& scene = "room")
{
    BenchSample sample;
    sample.key = config + std::to_string(samples) + scene;
    sample.config = config;
    sample.overrides = {"radius=1", "samples=" + std::to_string(samples)};
    sample.family = config;
    sample.scene = scene;
    sample.extent = {960, 540};
    sample.radius = 1;
    sample.rays = 256;
    sample.radius_px = 80;
    sample.samples = samples;
    sample.triangles = 1000;
    sample.device = "device A";
    sample.version = "1.0";
    sample.error.rmse = sample.error.rmse_fit = rmse;
    sample.error.bias = -rmse / 2;
    sample.error.p99 = 3 * rmse;
    sample.error.pixels = 500000;
    sample.error_without_ao = 0.35;
    sample.clock = "query";
    sample.repeats = 9;
    sample.total = {2 * ms, ms * 1.8, ms * 2.2};
    sample.cost = {ms, ms * 0.9, ms * 1.1};
    sample.passes = {{"geometry", {ms, ms, ms}}, {"ao", {ms, ms, ms}}};
    sample.ratio_learnopengl = ms * 10;
    return sample;
}

}  // namespace crevice
