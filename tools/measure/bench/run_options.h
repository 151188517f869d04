// SPDX-License-Identifier: MIT
// A bench on the console: its options, its run, and how it ends.
#pragma once

#include "tools/commands/cli/output.h"
#include "tools/measure/bench/run.h"

namespace CLI {
class App;
}

namespace crevice {

struct RunOptions {
    std::string time_budget;
    std::string out;  ///< A folder.
};

/// Adds --time-budget and --out.
void addRunOptions(CLI::App& app, RunOptions& options);

/// Seconds, of "90s", "5m", "1.5h" or plain seconds; 0 where the option was not given. Errors:
/// CV8001.
Result<double> timeBudgetOf(const RunOptions& options);

/// Measures all by `world.measure`, stops in good order on an interrupt, and says what came of it.
MeasureSummary measureOnConsole(const BenchPlan& plan, BenchFile& file, MeasureWorld world,
                                Progress& progress);

/// kExitBadInput where a sample failed; what could not be written and interrupts come first.
int exitCodeOf(const MeasureSummary& summary);

}  // namespace crevice
