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
    std::string shard = "1/1";
    std::string time_budget;
    std::string out;  ///< A folder.
};

/// Adds --shard, --time-budget and --out; `tasks` is what the command calls them, `kept` what else
/// the folder holds.
void addRunOptions(CLI::App& app, RunOptions& options, const std::string& tasks,
                   const std::string& kept);

/// Reads "3/8". Errors: CV8001.
Result<Shard> parseShard(const std::string& text);

/// Reads "90s", "5m", "1.5h" or plain seconds, above 0. Returns seconds. Errors: CV8001.
Result<double> parseDuration(const std::string& text);

/// The two, as the options have them.
struct RunLimits {
    Shard shard;
    double time_budget_s = 0;
};

/// Errors: CV8001.
Result<RunLimits> limitsOf(const RunOptions& options);

/// Measures all, stops in good order on an interrupt, and says what came of it.
MeasureSummary measureOnConsole(const MeasureJob& job, LineFile& file, double time_budget_s,
                                Progress& progress);

/// kExitBadInput where a task failed; what could not be written and interrupts come first.
int exitCodeOf(const MeasureSummary& summary);

}  // namespace crevice
