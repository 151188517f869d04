// SPDX-License-Identifier: MIT
// Which config to take: the most accurate within a time, or the cheapest within an error.
//
// A config must hold up in every scene that was measured, so its worst scene counts, for time and
// error apart.
#pragma once

#include "tools/measure/bench/views.h"

namespace crevice {

/// Which of the results are asked about.
struct ChoiceScope {
    std::string device;  ///< Part of a device's name; may stay empty where there is one device.
    std::string scene;   ///< Empty: all scenes.
    Extent extent;       ///< 0x0: the one with the most samples.
};

/// A config with its sample count and overrides, over all scenes of a scope. In each of them it is
/// less wrong than no ambient occlusion at all.
struct Candidate {
    std::string label;       ///< As sampleLabel has it.
    std::size_t sample = 0;  ///< One of its samples, for what is the same in all scenes.
    double ms = 0;           ///< BenchSample::cost: what it adds to a host that has a G-buffer.
    double ratio = 0;        ///< Of that over the copy cost.
    double error = 0;        ///< rmse.
    std::string slowest_view = {};
    std::string worst_view = {};
};

struct Candidates {
    std::string device;
    std::vector<ResultView> views;
    std::vector<Candidate> list;       ///< In the order of the results.
    std::vector<std::string> elided;   ///< What lacks figures in a view, and where.
    std::vector<std::string> harmful;  ///< Labels of what is no better than no ambient occlusion.
    double error_without_ao = 0;       ///< In the scene where it is largest.
};

/// Everything that can be chosen.
/// Errors: CV8001 for a scope that names no device, scene or size of the results, or for several
/// devices where none was named; CV7009 where no sample has figures.
Result<Candidates> findCandidates(const std::vector<BenchSample>& samples,
                                  const ChoiceScope& scope);

/// The candidates that no other beats: none is as cheap and less wrong, or as right and cheaper. By
/// rising time, hence falling error; of equals the first one. Those without a time are left out.
std::vector<std::size_t> frontOf(const std::vector<Candidate>& list);

/// The one of a front where more time begins to buy little: furthest below the straight line
/// between the ends, with time on a log scale; where none is below, the end with the smaller
/// product of time and error. Requires a front that is not empty.
std::size_t balancedOf(const std::vector<Candidate>& list, const std::vector<std::size_t>& front);

/// What is asked of a choice.
struct ChoiceLimit {
    enum class Kind { time_ms, copy_ratio, error };
    Kind kind = Kind::time_ms;
    double most = 0;
};

/// Reads "2ms", "500us", plain milliseconds, or "3x" for a multiple of the copy cost. Errors:
/// CV8001.
Result<ChoiceLimit> parseBudget(const std::string& text);

/// Into Candidates::list.
struct Choice {
    std::vector<std::size_t> within;  ///< The limit: the best first.
    std::vector<std::size_t> beyond;  ///< The nearest first.
};

/// Errors: CV4001 when nothing is within the limit; the help names what comes nearest, if anything.
Result<Choice> choose(const Candidates& candidates, ChoiceLimit limit);

/// "at most 2 ms".
std::string limitText(ChoiceLimit limit);

}  // namespace crevice
