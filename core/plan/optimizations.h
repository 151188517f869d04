// SPDX-License-Identifier: MIT
// The rules by which plans and frames leave out what changes no picture.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct RuleInfo {
    const char* name;     ///< As CompileOptions::keep and LeftOut::rule have it.
    const char* meaning;  ///< What it leaves out.
};

/// Those that may be switched off.
extern const RuleInfo kRules[7];

std::vector<std::string> ruleNames();

}  // namespace crevice
