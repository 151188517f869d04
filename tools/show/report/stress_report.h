// SPDX-License-Identifier: MIT
// The report of a stress run: one HTML file that needs no network.
#pragma once

#include "tools/measure/stress/run.h"

#include <string>

namespace crevice {

/// The page: each config's breakdown points with pictures, what holds where,
/// curves, and the pictures of failures, read below `folder`; those that cannot be read are left
/// out.
std::string stressHtml(const std::vector<StressRecord>& records, const std::string& folder);

}  // namespace crevice
