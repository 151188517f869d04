// SPDX-License-Identifier: MIT
// What commands that measure for long share: their options, a run on the console, and how it ends.
#pragma once

#include "tools/commands/cli/output.h"
#include "tools/measure/run.h"

#include <string>

namespace CLI {
class App;
}

namespace crevice {

struct RunOptions {
    std::string time_budget;
    std::string out;  ///< A folder.
};

/// Adds --time-budget and --out; `task` is what the command calls one, `kept` what the folder
/// holds.
void addRunOptions(CLI::App& app, RunOptions& options, const std::string& task,
                   const std::string& kept);

/// Seconds, of "90s", "5m", "1.5h" or plain seconds; 0 where the option was not given. Errors:
/// CV8001.
Result<double> timeBudgetOf(const RunOptions& options);

/// Measures all, stops in good order on an interrupt, and says what came of it.
MeasureSummary measureOnConsole(const MeasureJob& job, LineFile& file, double time_budget_s,
                                Progress& progress);

/// kExitBadInput where a task failed; what could not be written and interrupts come first.
int exitCodeOf(const MeasureSummary& summary);

}  // namespace crevice
