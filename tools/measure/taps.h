// SPDX-License-Identifier: MIT
// How many depth taps a pixel a config takes, and what to set in it for another number of them, or
// for a neighbour.
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

// --- for one a little cheaper, or a little more accurate ---

/// Values to try, one at a time, as --set has them: "steps=9", "steps=4", "ao_scale=0.5",
/// "back_faces=false". They are what decides how much is computed: whole numbers that shaders have
/// as a #define, a step of half as many up and down; what targets take their size from, a quarter
/// up and down; and each other word of each feature. Also what changes nothing of the occlusion:
/// plans tell.
std::vector<std::string> neighbourSettings(const Description& description);

/// "filter/box=filter/median" for each other filter of a config that names one.
std::vector<std::string> filterSwaps(const SourceSet& sources, const LoadRequest& request);

/// The overrides with `setting` in place of that param's or feature's.
std::vector<std::string> withSetting(std::vector<std::string> overrides,
                                     const std::string& setting);

}  // namespace crevice
