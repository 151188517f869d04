// SPDX-License-Identifier: MIT
// What one plan does otherwise than another: what `crevice explain --diff` prints.
#pragma once

#include <crevice/plan.h>

#include <string>
#include <utility>
#include <vector>

namespace crevice {

/// A pass, target or output that differs.
struct PlanChange {
    enum class Kind { only_before, only_after, changed };

    /// "fragment", "define SAMPLES", "input depth", "size", ...; an empty text means that there is
    /// nothing of that name on that side.
    struct Property {
        std::string name;
        std::string before;
        std::string after;
    };

    std::string section;  ///< "passes", "targets", "outputs" or "left out".
    std::string name;
    Kind kind = Kind::changed;
    std::vector<Property> properties = {};  ///< Those that differ; all of what is on one side only.
};

/// A number about the whole plan.
struct PlanTotal {
    std::string name;  ///< "passes", "textures", "texture_bytes", "bytes_read", "bytes_written".
    double before = 0;
    double after = 0;
};

struct PlanDiff {
    std::string before;  ///< "learnopengl 960x540".
    std::string after;
    std::vector<PlanChange> changes = {};  ///< In the order of the plans, section by section.
    std::vector<PlanTotal> totals = {};    ///< Bytes as in PlanPass, a frame.
};

/// Matches passes, targets and outputs by their names.
PlanDiff diffPlans(const Plan& before, const Plan& after);

/// Text for people.
std::string toText(const PlanDiff& diff);
std::string toJson(const PlanDiff& diff);

}  // namespace crevice
