// SPDX-License-Identifier: MIT
// Names of configs with modules laid over them: "mobile+geometry/host_depth".
#pragma once

#include <string>
#include <vector>

namespace crevice {

/// The config, and then each module: {"mobile", "geometry/host_depth"}. What ends in ".json" is one
/// file, whatever its path holds, and what begins with '{' the text of one.
std::vector<std::string> splitName(const std::string& name);

}  // namespace crevice
