// SPDX-License-Identifier: MIT
// A quick answer to which config to take in a view: `crevice choose --scene F`.
//
// Presets are drawn in a small picture first, whose cost and error say roughly what they are at
// full size. What could win (race.cpp) is drawn there and timed against
// `learnopengl`; then the other configs, and what is next to the best: steps, slices, resolution,
// features, filters. Errors are those over some thousands of pixels, with their margins
// (tools/measure/reference/sparse_truth.h), which shrink in the time that is left.
#pragma once

#include "tools/measure/bench/choice.h"
#include "tools/measure/bench/entrant.h"

#include <deque>

namespace crevice {

// --- race.cpp: which config to measure next, as a pure function of what is known of each ---
//
// Each has ranges for its cost and its error: wide ones from a small picture, narrow ones once it
// is measured at full size. What cannot win even with the best of its ranges is not measured.

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

// --- quick.cpp ---

struct QuickOptions {
    std::string scene;                        ///< Its name, as --scene has it.
    std::vector<std::string> configs;         ///< Empty: all shipped ones.
    std::vector<std::string> overrides = {};  ///< For every config, as --set has them.
    std::vector<std::string> roots = {};      ///< As LoadRequest has them.
    ChoiceLimits limits = {};                 ///< None: the most accurate wins.
    bool whole_front = false;  ///< Measure all that may be on the front, not only what may win.
    bool motion = false;       ///< Flicker counts as error: see flickerOf().
    double time_s = 50;        ///< Nothing is begun after it.
    std::string version = {};  ///< Of crevice.
    std::function<bool()> interrupted = [] { return false; };
    std::function<void(const std::string& line)> say = [](const std::string&) {};
};

/// What is known of an answer beside its figures.
struct QuickDetails {
    /// A config next to it: what its error and its cost are over the answer's; at full size where
    /// there was time for that, else in small pictures.
    struct Neighbour {
        std::string setting;  ///< As --set has it.
        double error = 0;
        double cost = 0;
        bool rough = false;  ///< By small pictures.
    };

    double error_margin = 0;    ///< Half the width of the error's 95 % interval.
    double ms_margin = 0;       ///< Of the cost's.
    double sure = 0;            ///< As sureness() has it.
    double dark = 0;            ///< Share of the squared error where the picture is too dark.
    std::size_t ruled_out = 0;  ///< Configs and settings that were drawn in a small picture alone.
    std::size_t not_begun = 0;  ///< Configs, for want of time.
    std::vector<Neighbour> neighbours;
    FrameShares frame;  ///< Zeros of any but the answer.
};

/// The device, the view and the sources must outlive it.
class QuickBench {
public:
    QuickBench(Device& device, const BenchView& view, const SourceSet& sources,
               QuickOptions options);

    /// Measures until the answer stands or the time is over; says a first answer, and each other
    /// one. Errors: those of ViewMeter::begin. What cannot be drawn is a warning.
    Status run();

    /// The next part of that, at most some tenths of a second: false where nothing is left. What
    /// `turns` then names is to be taken before the next. Errors: as `run`.
    Result<bool> step();

    /// What is to be drawn and timed now; null where that is nothing.
    Turns* turns() const { return meter_.turns(); }

    /// Once turns are taken, or have failed.
    void settle(const Status& taken);

    /// What was left out, and why.
    const Diagnostics& warnings() const { return warnings_; }

    /// What was measured at full size.
    std::vector<BenchSample> samples() const;

    /// Of one of the samples.
    QuickDetails detailsOf(const BenchSample& sample) const;

private:
    double seconds() const;
    bool mustStop() const { return options_.interrupted() || seconds() > options_.time_s; }
    Standing standingOf(const Entrant& entrant) const;
    std::vector<Standing> standings() const;
    std::optional<std::size_t> withoutNeighbours() const;
    void sayLeader(bool first_look = false);
    void enter(Entrant entrant);
    bool enterNext();
    bool enterNeighbours();
    void lookFull(std::size_t place);
    void leaveOut(const std::string& label, const Diagnostics& why);
    bool race();
    bool refine();

    const SourceSet& sources_;
    const QuickOptions options_;
    const double start_s_;
    ViewMeter meter_;
    enum class Stage { begin, first_look, truth, race, kin, pixels };
    Stage stage_ = Stage::begin;
    std::size_t next_config_ = 0;  // of options_.configs
    std::deque<Entrant> entrants_;
    std::deque<Entrant> to_enter_;
    std::deque<std::string> to_look_at_;                          // labels, at full size
    std::size_t pixels_ = kFullPixels, looked_by_ = kFullPixels;  // of the truth
    std::string looked_at_;                                       // its turns are due
    std::string leader_;
    FrameShares shares_;  // of the leader
    Diagnostics warnings_;
};

}  // namespace crevice
