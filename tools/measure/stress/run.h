// SPDX-License-Identifier: MIT
// A stress run: which steps are to be drawn, what is kept of them, breakdown points as
// sentences, and what is worse than in an earlier run.
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

/// Where a config breaks; of cases that break by the same effect under the same condition the one
/// that breaks first.
struct BreakdownPoint {
    std::string config;
    const StressCase* stress = nullptr;
    const StressRecord* after = nullptr;  ///< The first step that fails.
    std::string effect;                   ///< "is lost"
    std::string condition;                ///< "where the radius is taller than 0.7 screens"
    std::string held;   ///< The figures of the last step that holds and of `after`: "0.7" and
    std::string broke;  ///< ... "1.4"; empty where the ordinary step fails.
    std::string why;    ///< "3 % of the ground truth's occlusion"
};

/// In the order of `all`, whose records must outlive them.
std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all);

/// "AO of `gtao` is lost where the radius is taller than 0.7 screens: at 1.4, 3 % of the ground
/// truth's occlusion."
std::string sentenceOf(const BreakdownPoint& point);

/// How a step stood.
struct StressStanding {
    Outcome outcome = Outcome::holds;
    /// How far it is from the exact answer, 0 for none: rmse where there is ground truth, else in
    /// the unit of what the case expects.
    double error = 0;
};

/// By config and case, then by the steps' labels.
using KnownSteps =
    std::map<std::pair<std::string, std::string>, std::map<std::string, StressStanding>>;

KnownSteps standingsOf(const std::vector<StressSeries>& all);

/// A line a config and case.
std::string toLines(const KnownSteps& known);

/// Those of a file. Errors: CV7009.
Result<KnownSteps> readKnownSteps(const std::string& path);

/// Those of every shipped config, at 256x144.
const KnownSteps& shippedSteps();

/// The shipped config that the config is, or that it extends first; empty where it extends none or
/// cannot be read.
std::string shippedNameOf(const ConfigOptions& config, const SourceSet& sources);

/// Whose steps a config is compared with.
struct KnownConfig {
    std::string name;
    /// False: the config differs from it, so that only an error of twice its own is worse.
    bool same = true;
    /// Whether a step that is not known is left unjudged; else it counts as one that held.
    bool known_only = false;
};

/// Steps that fail where `known` has none that fails, and those whose error is larger than known by
/// more than kSameChange: "gtao, off_centre, 64: breaks: mean change 0.003". `unjudged` is raised
/// by the steps that are left so.
std::vector<std::string> worseThan(const KnownSteps& known, const KnownConfig& config,
                                   const StressSeries& series, int& unjudged);

}  // namespace crevice
