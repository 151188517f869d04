// SPDX-License-Identifier: MIT
// Having a config export all that its passes write, so that every target can be looked at.
#pragma once

#include <crevice/compile.h>

#include <string>
#include <vector>

namespace crevice {

/// A target that is looked at, and the output that shows it.
struct WatchedTarget {
    std::string target;
    std::string pass;
    std::string output;
};

/// The format that the plan has for a target of its own.
Format formatOf(const Plan& plan, const std::string& target);

/// Has the description export every target that a pass of the plan writes, in the passes' order.
std::vector<WatchedTarget> watchAll(const Plan& plan, Description& description);

}  // namespace crevice
