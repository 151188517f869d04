// SPDX-License-Identifier: MIT
// Where the pixels of what a user names come from: an output, a debug view or any target.
#pragma once

#include <crevice/compile.h>

namespace crevice {

/// How a request is met: the config's output that holds the pixels, and how a view shows them.
struct OutputSource {
    std::string output;
    float scale = 1.0f;
    float offset = 0.0f;
};

/// Finds the name among outputs, then views, then targets ("target.ao" where an output hides it),
/// and has the description export the target behind it. Errors: CV2209 with the names that would
/// do.
Result<OutputSource> exposeOutput(Description& description, const std::string& name);

/// value * scale + offset in every channel.
void applyView(Image& image, const OutputSource& source);

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
