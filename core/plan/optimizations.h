// SPDX-License-Identifier: MIT
// The optimizations by which plans and frames leave out what changes no picture.
#pragma once

#include <string>
#include <vector>

namespace crevice {

struct Optimization {
    const char* name;     ///< As CompileOptions::disable and Elided::optimization have it.
    const char* meaning;  ///< What it leaves out.
};

/// Those that may be switched off.
extern const Optimization kOptimizations[7];

std::vector<std::string> optimizationNames();

}  // namespace crevice
