// SPDX-License-Identifier: MIT
// The texts of the page: shipped modules and configs, and over them what the user edited.
#pragma once

#include <crevice/source.h>

namespace crevice::page {

/// All of them, as they are in force.
const SourceSet& sources();

}  // namespace crevice::page
