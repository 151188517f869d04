// SPDX-License-Identifier: MIT
// What keeps a config from the ground truth, and the same config without it.
//
// Each part of an error budget has an edit of the description, found from what that declares: its
// params, the sizes of its targets, the passes between its estimator and its output. A config that
// has nothing to edit stays as it is.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// The parts, as bits, so that several can be ideal at once.
enum Ideal : unsigned {
    kIdealTaps = 1,      ///< As many as the ranges allow, the mean over seeds.
    kIdealFilter = 2,    ///< None: the filter is left out.
    kIdealSize = 4,      ///< Occlusion at the size of the view.
    kIdealScreen = 8,    ///< Twice as wide and high as the view.
    kIdealLayers = 16,   ///< A second layer of depth and back faces, for those that read them.
    kIdealFormats = 32,  ///< Float targets of 32 bits.
    kIdealEverything = 63,
};

/// What stands in the config where its estimator's picture goes into the filter: "ao".
constexpr const char* kOcclusionTarget = "ao";

/// The output `ao`, without the passes between the target `ao` and it that keep its size. They are
/// found by what they declare in `preserves_constant`; an upsampling pass stays.
void leaveOutFilter(Description& description);

/// The target `ao` at the size of the view.
void takeFullSize(Description& description);

/// The largest param `guard_band`; false where the config has none.
bool takeGuardBand(Description& description);

/// What `added` has and the config lacks; of params and features that both have the values of
/// `added`.
void layOver(Description& description, const Description& added);

/// Every target in the widest format of as many channels that the device renders to and that stands
/// in for its own: 32-bit floats cannot be filtered.
void widenFormats(Description& description, const DeviceCaps& caps);

}  // namespace crevice
