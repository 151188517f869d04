// SPDX-License-Identifier: MIT
// Diagnostics as SARIF 2.1.0 (OASIS, "Static Analysis Results Interchange Format"), which editors
// and code hosts show at the line that they are about.
#pragma once

#include <crevice/diagnostic.h>

#include <string>
#include <vector>

namespace crevice {

/// A code, its name in <crevice/codes.h> and what it means, as that file says it.
struct CodeRule {
    Code code;
    std::string name;  ///< "target_missing"
    std::string text;  ///< "A pass or output names a target that does not exist."
};

/// All codes in the order of <crevice/codes.h>.
const std::vector<CodeRule>& codeRules();

/// A log of one run: a rule for each code that occurs, a result for each diagnostic, with its
/// place, its pointer, its notes as related places and its help in the message. Columns count
/// characters.
std::string toSarif(const Diagnostics& diagnostics, const std::string& version);

}  // namespace crevice
