// SPDX-License-Identifier: MIT
// A config that reads a host's textures, where there is no host.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// The errors with another help for each texture that a frame lacks (CV6010): what draws the config
/// without a host, a feature to switch off or a module to swap.
Diagnostics withoutHost(Diagnostics errors, const Description& description);

}  // namespace crevice
