// SPDX-License-Identifier: MIT
// Private to effects/api: what the levels of a front must be, whoever made them.
#pragma once

#include <crevice/governor.h>

namespace crevice {

/// Errors: CV3006 for no level; CV4001 for times that are not above 0 or do not rise, and for
/// errors below 0; CV4003; each at its level.
Status checkFront(const std::vector<FrontLevel>& levels);

/// What is wrong with a level's config, with the level's place.
Diagnostics ofLevel(const FrontLevel& level, Diagnostics found);

}  // namespace crevice
