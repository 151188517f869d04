// SPDX-License-Identifier: MIT
// What is wrong with the targets of a frame, which pass did it, and what probably made it do so.
#pragma once

#include <crevice/compile.h>

namespace crevice {

/// A pixel, counted from the upper left as pictures show it.
struct PixelPlace {
    int x = 0, y = 0;
};

/// What a target held after a frame.
struct TargetHealth {
    std::string target;
    std::string pass;  ///< The one that writes it.
    std::size_t pixels = 0;
    std::size_t undefined = 0;  ///< Pixels that depend on what memory held before.
    std::size_t not_numbers = 0;
    std::size_t infinite = 0;
    std::size_t out_of_range = 0;                 ///< Past what its format holds: a shader's fault.
    PixelPlace first_bad;                         ///< The uppermost of any of these.
    float first_value = 0;                        ///< There, of what its format does not hold.
    std::array<float, 4> minimum = {0, 0, 0, 0};  ///< By channel, of the finite values.
    std::array<float, 4> maximum = {0, 0, 0, 0};
    int channels = 0;
    bool constant = false;  ///< All pixels are equal.

    bool bad() const { return undefined + not_numbers + infinite + out_of_range > 0; }
};

/// Looks at one target drawn twice, in memory with different contents before. Requires images of
/// one size and number of channels.
TargetHealth examine(const Image& drawn, const Image& redrawn);

/// Adds what the same target held in 32-bit floats (tools/render/device/poison_device.h), where its
/// own format `stored` hides values that it does not have: not a number, infinity, and what lies
/// outside of [0, 1] or of half floats by more than rounding.
void examineFloats(const Image& floats, Format stored, TargetHealth& health);

/// Why the plan put a constant in the place of an output; empty where it does not know.
std::string whyPlanned(const Plan& plan);

/// The first pass that wrote what no pass should, as an error CV9001, CV9002 or CV9004 with the
/// likely cause as help; then each output that is the same everywhere, as a warning CV9003.
/// `health` holds every target that a pass of the plan writes, in the order of the passes. Empty
/// where nothing is wrong.
Diagnostics diagnose(const Description& description, const Plan& plan,
                     const std::vector<TargetHealth>& health);

}  // namespace crevice
