// SPDX-License-Identifier: MIT
// How each step of a config stood in an earlier run, and what is worse since: `crevice stress` as a
// gate.
//
// A file of known steps has a line a config and case, for those of shipped configs in
// docs/stress/known.jsonl: {"case":"near_far","config":"gtao","steps":{"1:1e1":0.03,
// "0.01:1e4":["breaks",0.12]}}. A number alone is the error of a step that holds.
#pragma once

#include "tools/measure/stress/run.h"

namespace crevice {

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
