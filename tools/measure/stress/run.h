// SPDX-License-Identifier: MIT
// A stress run: which steps are to be drawn, and what is kept of them.
#pragma once

#include "tools/measure/stress/runner.h"

namespace crevice {

struct StressOptions {
    std::vector<std::string> configs = {};  ///< Empty: every shipped config.
    std::vector<std::string> cases = {};    ///< Empty: all.
    std::string variant = {};
    std::vector<std::string> overrides = {};
    bool quick = false;                   ///< Two or three steps of each case.
    std::vector<std::string> roots = {};  ///< As LoadRequest has them.
};

/// Config by config, case by case, each from the first step to the last.
///
/// Errors: CV8001 for an unknown case, those of loadDescription for an unusable config.
Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources);

/// "gtao, near_far, 0.01:1e4".
std::string stepTitle(const StressTask& task);

/// Draws the steps and writes their records to stress.jsonl in the folder, how they stand to
/// known.jsonl, and pictures of those that fail. Errors: CV7007.
Result<std::vector<StressRecord>> runStress(
    const std::vector<StressTask>& tasks, const std::string& folder,
    const std::function<StressDrawing(const StressTask&)>& draw);

/// The records of one config and case.
struct StressSeries {
    const StressCase* stress = nullptr;
    std::string config;
    std::vector<const StressRecord*> steps;  ///< By step; null where there is none.
};

/// Where the ground truth's picture lies, beside that of a failure.
std::string truthPictureOf(const StressRecord& record);

/// In the order in which they come. The records and cases must outlive them; records of other cases
/// are left out.
std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records,
                                   const std::vector<StressCase>& cases = stressCases());

}  // namespace crevice
