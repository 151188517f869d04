// SPDX-License-Identifier: MIT
// A stress run: which steps are to be drawn, and the loop that draws them.
#pragma once

#include "tools/bench/bench.h"
#include "tools/stress/meter.h"

#include <functional>
#include <string>
#include <vector>

namespace crevice {

struct StressOptions {
    std::vector<std::string> configs = {};  ///< Empty: every shipped config.
    std::vector<std::string> cases = {};    ///< Empty: all.
    std::string variant = {};
    std::vector<std::string> overrides = {};
    bool quick = false;  ///< Two or three steps of each case, in the configs' own formats.
    Shard shard = {};    ///< By config and case.
    std::vector<std::string> roots = {};  ///< As LoadRequest has them.
};

/// Config by config, case by case, format by format, each from the first step to the last.
///
/// Errors: CV8001 for an unknown case, those of loadDescription for an unusable config.
Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources);

/// "gtao, near_far depth=depth16, 0.01:1e4".
std::string stepTitle(const StressTask& task);

/// The world around the loop; tests put in their own.
struct StressWorld {
    std::function<std::string(const StressTask&)> key;
    std::function<StressDrawing(const StressTask&)> measure;
    std::function<Status(const StressDrawing&)> keep;  ///< Of a failure, before its line is written.
    std::function<double()> seconds;
    std::function<bool()> interrupted;
    std::function<void(const std::string& line)> say;
    std::string device;
    std::string version;
    double time_budget_s = 0;  ///< No step is begun after it; 0: no limit.
};

struct StressSummary {
    int measured = 0;
    int kept = 0;     ///< Had figures from an earlier run.
    int missing = 0;  ///< Not begun.
    bool interrupted = false;
    Status written;
    std::vector<StressRecord> records;  ///< Of the tasks, in their order; those not begun left out.
};

/// Draws every step that `known` has no record of and adds it to the file.
StressSummary runStress(const std::vector<StressTask>& tasks,
                        const std::vector<StressRecord>& known, LineFile& file,
                        const StressWorld& world);

/// The records of one config, case and format.
struct StressSeries {
    const StressCase* stress = nullptr;
    std::string config;
    std::string format;
    std::vector<const StressRecord*> steps;  ///< By step; null where there is none.
};

/// In the order in which they come. The records must outlive them; those of unknown cases are left out.
std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records);

}  // namespace crevice
