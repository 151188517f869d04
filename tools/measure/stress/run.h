// SPDX-License-Identifier: MIT
// A stress run: which steps are to be drawn, and what the engine of tools/measure does with one.
#pragma once

#include "tools/measure/run.h"
#include "tools/measure/stress/runner.h"

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
    std::vector<std::string> roots = {};  ///< As LoadRequest has them.
};

/// Config by config, case by case, format by format, each from the first step to the last.
///
/// Errors: CV8001 for an unknown case, those of loadDescription for an unusable config.
Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources);

/// "gtao, near_far depth=depth16, 0.01:1e4".
std::string stepTitle(const StressTask& task);

/// How steps are drawn; tests put in their own.
struct StressHow {
    std::function<std::string(const StressTask&)> key;
    std::function<StressDrawing(const StressTask&)> measure;
    /// Of a failure, before its line is written.
    std::function<Status(const StressDrawing&)> keep;
    std::string device;
    std::string version;
};

/// What the engine needs to draw the steps that `known` has no record of. The tasks and the records
/// must outlive it.
MeasureJob stressJob(const std::vector<StressTask>& tasks, const std::vector<StressRecord>& known,
                     StressHow how);

/// The file's records of the job's tasks, in their order; those not begun are left out. Errors:
/// those of readStressRecords.
Result<std::vector<StressRecord>> recordsOf(const MeasureJob& job, const std::string& file);

/// The records of one config, case and format.
struct StressSeries {
    const StressCase* stress = nullptr;
    std::string config;
    std::string format;
    std::vector<const StressRecord*> steps;  ///< By step; null where there is none.
};

/// "near_far depth=depth16".
std::string seriesName(const StressSeries& series);

/// In the order in which they come. The records must outlive them; those of unknown cases are left
/// out.
std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records);

}  // namespace crevice
