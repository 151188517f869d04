// SPDX-License-Identifier: MIT
// How many depth taps a pixel a config takes, and what to set for another number of them.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// The param `samples`, or 2 * `slices` * `steps` of an estimator that marches over the screen both
/// ways; 0 for a config that has neither.
int samplesOf(const Description& description);

/// What to set, as --set has it, for `count` taps: "samples=16", or "slices=2" and "steps=4" with a
/// ratio as near to the config's own as divisors allow. Empty where the params' ranges do not hold
/// it.
std::vector<std::string> overridesFor(const Description& description, int count);

}  // namespace crevice
