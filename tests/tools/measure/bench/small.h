// SPDX-License-Identifier: MIT
// A small bench to plan, for tests without GL.
#pragma once

#include <crevice/shipped.h>

#include "tests/support/catch.h"
#include "tools/measure/bench/bench.h"

namespace crevice {

inline BenchOptions smallOptions()
{
    BenchOptions options;
    options.configs = {"learnopengl", "thesis"};
    options.scenes = {"plane", "spheres"};
    options.sizes = {"64x36"};
    options.samples = {4, 16};
    return options;
}

inline BenchPlan plan(const BenchOptions& options)
{
    const Result<BenchPlan> made = planBench(options, shippedSources());
    INFO(toText(made.diagnostics()));
    REQUIRE(made.ok());
    return *made;
}

}  // namespace crevice
