// SPDX-License-Identifier: MIT
// Where the pixels of what a user names come from: an output, a debug view or any target.
#pragma once

#include <crevice/config.h>
#include <crevice/image.h>
#include <crevice/result.h>

#include <string>

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

}  // namespace crevice
