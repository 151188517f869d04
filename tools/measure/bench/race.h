// SPDX-License-Identifier: MIT
// Which config to measure next, so that the best one is known soon; as a pure function of what is
// known of each.
//
// Each has ranges for its cost and its error: wide ones from a small picture, narrow ones once it
// is measured at full size. What cannot win even with the best of its ranges is not measured.
#pragma once

#include "tools/measure/bench/choice.h"
#include "tools/measure/reference/sparse_truth.h"

#include <optional>

namespace crevice {

/// A figure, and what it is between at 95 % confidence.
struct Range {
    double value = 0;
    double low = 0;
    double high = 0;
};

/// Of a figure with half the width of its interval.
inline Range rangeOf(double value, double margin)
{
    return {value, std::max(0.0, value - margin), value + margin};
}

/// `figure` times what such figures grew by elsewhere.
Range scaled(const Range& figure, const Range& factor);

/// What factors tell of another one that was not seen: from their least to their greatest, and
/// half as much again, since they are few. Without any, from a third to three.
Range factorOf(const std::vector<double>& factors);

/// What is known of a config.
struct Standing {
    Range ms;
    Range ratio;  ///< Of its cost over that of learnopengl.
    Range error;
    bool measured = false;                ///< At full size.
    const SparseError* pixels = nullptr;  ///< Of the error, where it is known.
};

/// The probability, if the ranges are right, that one is within the limits and that no other that
/// was measured is better by over kWorth.
double sureness(const std::vector<Standing>& standings, std::size_t one,
                const ChoiceLimits& limits);

/// The figure that a limit of the kind is about.
const Range& spentOf(const Standing& standing, ChoiceLimit::Kind kind);

/// The best of those that were measured, as choose() has it. Nothing where none is within the
/// limits.
std::optional<std::size_t> leaderOf(const std::vector<Standing>& standings,
                                    const ChoiceLimits& limits);

/// The one that spends least of the limit it spends most of. Requires one.
std::size_t nearestOf(const std::vector<Standing>& standings, const ChoiceLimits& limits);

/// The one to measure next: of those not measured that could be within the limits and beat the
/// leader, the most promising. Nothing where none could. With `whole_front` what could be on the
/// front of cost and error counts, too, after those.
std::optional<std::size_t> nextOf(const std::vector<Standing>& standings,
                                  const ChoiceLimits& limits, bool whole_front = false);

}  // namespace crevice
