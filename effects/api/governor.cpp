// SPDX-License-Identifier: MIT
#include <crevice/governor.h>

#include "core/base/text.h"
#include "effects/api/front.h"

#include <cmath>
#include <limits>

namespace crevice {
namespace {

/// A time above the budget heats by kHeat, another cools by 1; at kHot the level goes down. A new
/// level begins with kWarm, so that its first time above the budget is enough.
constexpr int kHeat = 3, kHot = 5, kWarm = 2;

/// A frame in which no better level is predicted to fit takes back as many that had one.
constexpr int kMisfit = 9;

/// Times from which a step is learnt: more would mix in other scenes, fewer are noise.
constexpr std::size_t kSettled = 16;

/// A step up that lasts this many waits was no mistake.
constexpr int kSoon = 10;

/// A cost is at most this far off the front's, in either direction.
constexpr double kMostOff = 4;

/// One step down tells little, as the load has just changed: it corrects a ratio by this at most.
constexpr double kByOneStep = 1.3;

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Status checkOptions(const GovernorOptions& options)
{
    const struct {
        const char* what;
        double value;
        bool good;
        const char* help;
    } rows[] = {
        {"budget", options.budget_ms, options.budget_ms > 0 && std::isfinite(options.budget_ms),
         "give the milliseconds that a frame's AO may take, above 0"},
        {"largest error", options.most_error, options.most_error >= 0, "give 0 for none"},
        {"share", options.share, options.share > 0 && options.share <= 1, "give (0, 1]"},
        {"wait", double(options.wait), options.wait >= 1 && options.wait <= 1000,
         "give 1 to 1000 frames"},
    };
    for (const auto& row : rows)
        if (!row.good)
            return Diagnostic{
                Code::out_of_range,
                std::string("the governor's ") + row.what + " is " + significant(row.value, 4),
                row.help};
    return {};
}

}  // namespace

Status checkFront(const std::vector<FrontLevel>& levels)
{
    if (levels.empty() || levels.size() > kMostLevels)
        return Diagnostic{Code::bad_length,
                          "a front has " + std::to_string(levels.size()) + " levels",
                          "give it 1 to " + std::to_string(kMostLevels)};
    double before = 0;
    for (const FrontLevel& each : levels) {
        const bool finite = std::isfinite(each.ms) && std::isfinite(each.error);
        if (!finite || each.ms <= before || each.error < 0)
            return Diagnostic{finite ? Code::out_of_range : Code::not_finite,
                              "level '" + each.name + "' has " + significant(each.ms, 6) +
                                  " ms and an error of " + significant(each.error, 6) +
                                  ", wanted more than " + significant(before, 6) +
                                  " ms and an error of 0 or more",
                              "sort levels by their milliseconds; an error of 0 is not known",
                              each.place, each.pointer};
        before = each.ms;
    }
    return {};
}

Result<std::vector<FrontLevel>> frontOf(const std::vector<BakedConfig>& baked)
{
    std::vector<FrontLevel> levels;
    for (const BakedConfig& each : baked) {
        if (each.ms == 0)
            return Diagnostic{Code::not_baked, "'" + each.name + "' was baked without its time",
                              "bake the levels of a governor by crevice bake --front FILE"};
        levels.push_back({{each.name}, each.set, each.ms, each.error});
    }
    return levels;
}

Governor::Governor(std::vector<FrontLevel> levels, const GovernorOptions& options)
    : levels_(std::move(levels)),
      options_(options)
{
    double least = std::numeric_limits<double>::infinity();
    for (const FrontLevel& each : levels_) {
        const bool known = each.error > 0;
        const bool better = !known || each.error < least;
        const bool allowed = options.most_error == 0 || (known && each.error <= options.most_error);
        if (better && allowed) used_.push_back({static_cast<int>(&each - levels_.data()), each.ms});
        if (known) least = std::min(least, each.error);
    }
}

Result<Governor> Governor::create(std::vector<FrontLevel> levels, const GovernorOptions& options)
{
    if (Status status = checkOptions(options); !status) return status.diagnostics();
    if (Status status = checkFront(levels); !status) return status.diagnostics();
    Governor made(std::move(levels), options);
    if (made.used_.empty())
        return Diagnostic{Code::out_of_range,
                          "no level has an error of at most " + significant(options.most_error, 4),
                          "allow a larger error, or add a better level", made.levels_.back().place};
    made.now_ = made.used_.size() - 1;
    if (!made.fits(made.now_, 1)) made.now_ = made.levelBelow(1);
    return made;
}

bool Governor::fits(std::size_t at, double load) const
{
    return used_[at].cost * load <= options_.share * options_.budget_ms;
}

/// The best below the present one that fits the load; where none does, the cheapest below it.
std::size_t Governor::levelBelow(double load) const
{
    std::size_t cheapest = 0;
    for (std::size_t at = now_; at-- > 0;) {
        if (fits(at, load)) return at;
        if (used_[at].cost < used_[cheapest].cost) cheapest = at;
    }
    return cheapest;
}

void Governor::addTime(double ms, int at)
{
    const double load = ms / used_[now_].cost;
    if (at != level() || !(load > 0) || !std::isfinite(load)) return;
    ms_ = ms;
    load_ = load;
    if (loads_.size() < kSettled) loads_.push_back(load_);
    loads_[times_++ % kSettled] = load_;
    if (since_up_ > 0 && ++since_up_ > kSoon * options_.wait) {
        since_up_ = 0;
        patience_ = 1;
    }
    if (times_ == kSettled && before_ > 0) learn();
    std::size_t better = now_ + 1;
    while (better < used_.size() && !fits(better, load_)) ++better;
    const bool better_fits = better < used_.size();
    calm_ = better_fits ? calm_ + 1 : std::max(0, calm_ - kMisfit);
    if (ms > options_.budget_ms) {
        const double least = over_load_ > 0 ? std::min(over_load_, load_) : load_;
        over_load_ = load_;
        heat_ = std::min(heat_ + kHeat, kHot);
        if (heat_ == kHot) return stepDown(least);
    } else if (heat_ > 0 && --heat_ == 0) {
        over_load_ = 0;
    }
    if (!better_fits || calm_ < options_.wait * patience_) return;
    before_ = median(loads_);
    since_up_ = 1;
    go(better);
}

void Governor::stepDown(double load)
{
    const std::size_t to = levelBelow(load);
    if (to == now_) return;
    if (since_up_ > 0) patience_ = std::min(2 * patience_, kMostPatience);
    most_raise_ = since_up_ > 0 && times_ < kSettled ? kByOneStep : 1;
    since_up_ = 0;
    before_ = load_ = load;
    go(to);
}

void Governor::go(std::size_t to)
{
    other_ = std::exchange(now_, to);
    loads_.clear();
    times_ = 0;
    calm_ = 0;
    heat_ = kWarm;
    ms_ = over_load_ = 0;
}

/// The load at this level is known now, and that before the step: where they differ, the better of
/// both levels costs more or less than was thought, and so do those above it.
void Governor::learn()
{
    const double now = median(loads_), before = std::exchange(before_, 0.0);
    const bool rose = now_ > other_;
    const double off = rose ? now / before : std::clamp(before / now, 1 / kByOneStep, most_raise_);
    const double cost = used_[now_].cost;
    for (std::size_t at = std::max(now_, other_); at < used_.size(); ++at) {
        const double front = levels_[static_cast<std::size_t>(used_[at].level)].ms;
        used_[at].cost = std::clamp(used_[at].cost * off, front / kMostOff, front * kMostOff);
    }
    if (!rose) return;
    load_ = before;
    for (double& each : loads_) each *= cost / used_[now_].cost;
}

Status Governor::setBudget(double budget_ms)
{
    GovernorOptions options = options_;
    options.budget_ms = budget_ms;
    if (Status status = checkOptions(options); !status) return status;
    options_ = options;
    heat_ = calm_ = 0;
    over_load_ = 0;
    return {};
}

void Governor::stayAt(int level)
{
    for (std::size_t at = 0; at < used_.size(); ++at)
        if (used_[at].level == level) go(at);
    before_ = 0;
    since_up_ = 0;
    patience_ = std::min(2 * patience_, kMostPatience);
}

GovernorReport Governor::report() const
{
    const FrontLevel& now = levels_[static_cast<std::size_t>(level())];
    return {level(), ms_, load_ * used_[now_].cost, now.error, estimate_};
}

}  // namespace crevice
