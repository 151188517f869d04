// SPDX-License-Identifier: MIT
// The governor: which of several levels of AO to draw, so that a frame's AO stays within a budget.
//
//     auto front = readFront("front.json");   // of `crevice choose --write-front`
//     effect->govern(*front, {2.0});          // at most 2 ms of GPU time a frame
//     effect->render();                       // each frame, at the level that fits
//     effect->governor()->report();           // level, time, error
//
// It has no clock and no GL: the same times give the same levels. Times may come some frames late.
//
//   down  at the second time above the budget among three, or where more than every fourth is, at
//         once to the best level that is predicted to fit. One slow frame changes nothing. Where
//         the new level is above the budget too, its first time is enough.
//   up    to the next better level that fits, once kept below `share` of the budget in nine of ten
//         frames, for `wait` frames. Where that was wrong soon, the next wait is twice as long, up
//         to kMostPatience times `wait`.
//
// A prediction for a level is the time of now by the ratio of both levels' times: the front's,
// corrected at each step by what was measured, up to four times either way. So a front of another
// device will do.
#pragma once

#include <crevice/diagnostic.h>

namespace crevice {

/// One step of a front: a config, what it costs and how well it does. `name` is the config's, as
/// Effect::create takes it.
struct FrontLevel : Named {
    std::vector<std::string> set = {};  ///< "radius=1": params and features, as --set takes them.
    double ms = 0;     ///< GPU time of a frame, in milliseconds, above 0: only ratios matter much.
    double error = 0;  ///< Of the bench, above 0; 0 where nobody knows.
};

/// So many levels may a front have: programs of all are kept.
constexpr std::size_t kMostLevels = 64;

/// Reads a front, as `crevice choose --write-front` writes it: levels by rising ms. `front` is a
/// file's path, or JSON text that begins with '{'. `scene`, `size`, `device`, `set` may be missing.
///
///     { "format": "crevice-front-1", "scene": "room", "size": [960, 540], "device": "...",
///       "levels": [ {"config": "mobile", "set": ["radius=1"], "ms": 1.1, "error": 0.078}, ... ] }
///
/// Errors: CV1201 for no file, those of parseDocument, CV3001 to CV3006 for keys and types, CV4001
/// for numbers. Whether configs exist, and take what is set, is seen by Effect::govern.
Result<std::vector<FrontLevel>> readFront(const std::string& front);

struct GovernorOptions {
    double budget_ms = 0;  ///< Milliseconds of a frame that the effect may take, above 0. Required.
    double most_error = 0;  ///< Levels of a larger error, or of none known, are not used; 0: all.
    double share = 0.9;     ///< Of the budget, within which a better level must stay, (0, 1].
    int wait = 30;          ///< Frames for which it must be predicted to, [1, 1000].
};

/// What a frame is drawn at, and why.
struct GovernorReport {
    int level = 0;            ///< To be drawn next; into the front.
    double ms = 0;            ///< The latest time at the level; 0 before there is one.
    double predicted_ms = 0;  ///< What the level is predicted to take; above the budget: none fits.
    double error = 0;         ///< The bench's, as the front has it; 0 where it is not known.
    double estimate = 0;      ///< Of the picture's, two or three frames ago (kErrorEstimate); or 0.
};

/// The output that estimates a frame's error without knowing the truth (docs/reference/doubt.md).
/// Ask for it in Effect::create, as outputs {"ao", kErrorEstimate}, and take levels that have it.
constexpr const char* kErrorEstimate = "doubt_rmse";

class Governor {
public:
    static constexpr int kMostPatience = 16;

    /// Begins at the best level that fits by the front's times. Levels that have no less error than
    /// a cheaper one are not used.
    ///
    /// Errors: CV3006 for no level or more than kMostLevels; CV4001 and CV4003 for numbers out of
    /// range, for times that do not rise, and where no level is as good as `most_error`.
    static Result<Governor> create(std::vector<FrontLevel> levels, const GovernorOptions& options);

    /// The level to draw the next frame at, into `levels`.
    int level() const { return used_[now_].level; }

    /// Takes what a frame drawn at `level` took, in milliseconds. Those of a level that is no
    /// longer drawn change nothing, nor do those that are not above 0 or not finite: void, or
    /// nothing ran.
    void addTime(double ms, int level);
    void addTime(double ms) { addTime(ms, level()); }

    /// Goes on with another budget. Errors: CV4001 unless it is above 0; the old one stays.
    Status setBudget(double budget_ms);

    /// Takes what `report` says the drawn picture's error is expected to be; levels do not depend
    /// on it.
    void setEstimate(double error) { estimate_ = error; }

    /// Goes on at a level that was drawn, the present one being impossible to draw.
    void stayAt(int level);

    GovernorReport report() const;
    const std::vector<FrontLevel>& levels() const { return levels_; }

private:
    /// A level that is used.
    struct Used {
        int level;    // into levels_
        double cost;  // relative to the others': its ms as the front has it, corrected
    };

    Governor(std::vector<FrontLevel> levels, const GovernorOptions& options);

    bool fits(std::size_t at, double load) const;
    std::size_t levelBelow(double load) const;
    void stepDown(double load);
    void go(std::size_t to);
    void learn();

    std::vector<FrontLevel> levels_;
    GovernorOptions options_;
    std::vector<Used> used_;  // from the worst to the best
    std::size_t now_ = 0;     // into used_

    // A load is a time divided by its level's cost: what it was drawn at has gone out of it.
    std::vector<double> loads_;  // the first kSettled at this level, then the last ones, in turn
    std::size_t times_ = 0;      // at this level
    double ms_ = 0;              // the latest
    double estimate_ = 0;        // of the error
    double load_ = 1;            // ... divided by the cost, or what a step down was decided by
    double before_ = 0;          // load at the level of before, until the step is learnt from
    std::size_t other_ = 0;      // that level
    double most_raise_ = 1;      // of its cost, where it was the better one
    int heat_ = 0;               // what times above the budget add to
    double over_load_ = 0;       // of the last one; 0 when that is past
    int calm_ = 0;               // frames for which a better level was predicted to fit
    int since_up_ = 0;           // times since the last step up, until that is called a success
    int patience_ = 1;           // waits to wait
};

}  // namespace crevice
