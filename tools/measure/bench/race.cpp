// SPDX-License-Identifier: MIT
#include "tools/measure/bench/quick.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr double kUnseen = 1.5;   // beyond the factors that were seen
constexpr double kUnknown = 3.0;  // where none was

/// What is to be small within the limits.
const Range& meritOf(const Standing& standing, const ChoiceLimits& limits)
{
    return wantsLeastTime(limits) ? standing.ms : standing.error;
}

/// The index of the least value among those that the condition holds of.
template <class Condition, class Value>
std::optional<std::size_t> leastOf(const std::vector<Standing>& all, Condition&& holds,
                                   Value&& value)
{
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (holds(all[i]) && (!best || value(all[i]) < value(all[*best]))) best = i;
    return best;
}

/// The part of a normal distribution below so many standard deviations.
double below(double deviations) { return 0.5 * std::erfc(-deviations / std::sqrt(2.0)); }

/// The probability that what the range is of is at most `most`.
double chanceBelow(const Range& range, double most)
{
    constexpr double kWidth = 2 * kConfidence;  // of 95 %, in standard deviations
    return below((most - range.value) / std::max(1e-12, (range.high - range.low) / kWidth));
}

double chanceWithin(const Standing& standing, const ChoiceLimits& limits)
{
    double chance = 1.0;
    for (const ChoiceLimit& limit : limits)
        chance *= chanceBelow(spentOf(standing, limit.kind), limit.most);
    return chance;
}

/// The probability that `other` beats `one` in what is to be small, by more than counts.
double chanceBetter(const Standing& other, const Standing& one, const ChoiceLimits& limits)
{
    const double share = 1.0 - kWorth;
    if (!wantsLeastTime(limits) && other.pixels && one.pixels)
        return below(deviationsBelow(*other.pixels, *one.pixels, share));
    const Range &its = meritOf(other, limits), &own = meritOf(one, limits);
    const double width = std::hypot(its.high - its.low, share * (own.high - own.low));
    return chanceBelow({its.value, its.value - width / 2, its.value + width / 2},
                       share * own.value);
}

}  // namespace

double sureness(const std::vector<Standing>& standings, std::size_t one, const ChoiceLimits& limits)
{
    double sure = chanceWithin(standings[one], limits);
    for (std::size_t i = 0; i < standings.size(); ++i)
        if (i != one && standings[i].measured)
            sure *= 1.0 - chanceBetter(standings[i], standings[one], limits) *
                              chanceWithin(standings[i], limits);
    return sure;
}

const Range& spentOf(const Standing& standing, ChoiceLimit::Kind kind)
{
    if (kind == ChoiceLimit::Kind::error) return standing.error;
    return kind == ChoiceLimit::Kind::time_ms ? standing.ms : standing.ratio;
}

Range scaled(const Range& figure, const Range& factor)
{
    return {figure.value * factor.value, figure.low * factor.low, figure.high * factor.high};
}

Range factorOf(const std::vector<double>& factors)
{
    if (factors.empty()) return {1.0, 1.0 / kUnknown, kUnknown};
    const auto [least, most] = std::minmax_element(factors.begin(), factors.end());
    std::vector<double> sorted = factors;
    std::sort(sorted.begin(), sorted.end());
    return {sorted[sorted.size() / 2], *least / kUnseen, *most * kUnseen};
}

std::optional<std::size_t> leaderOf(const std::vector<Standing>& standings,
                                    const ChoiceLimits& limits)
{
    Candidates all;
    for (std::size_t i = 0; i < standings.size(); ++i) {
        const Standing& it = standings[i];
        if (it.measured) all.list.push_back({"", i, it.ms.value, it.ratio.value, it.error.value});
    }
    const Result<Choice> choice = choose(all, limits);
    if (!choice) return std::nullopt;
    return all.list[choice->within[0]].sample;
}

std::size_t nearestOf(const std::vector<Standing>& standings, const ChoiceLimits& limits)
{
    const auto spent = [&](const Standing& standing) {
        double most = 0;
        for (const ChoiceLimit& limit : limits)
            most = std::max(most, spentOf(standing, limit.kind).value / limit.most);
        return most;
    };
    return *leastOf(
        standings, [](const Standing&) { return true; }, spent);
}

std::optional<std::size_t> nextOf(const std::vector<Standing>& standings,
                                  const ChoiceLimits& limits, bool whole_front)
{
    const auto merit = [&](const Standing& s) { return meritOf(s, limits).value; };
    const std::optional<std::size_t> leader = leaderOf(standings, limits);
    const auto may_lead = [&](const Standing& s) {
        const auto breaks = [&s](const ChoiceLimit& limit) {
            return spentOf(s, limit.kind).low > limit.most;
        };
        if (s.measured || anyOf(limits, breaks)) return false;
        return !leader || meritOf(s, limits).low < merit(standings[*leader]);
    };
    if (const auto next = leastOf(standings, may_lead, merit); next || !whole_front) return next;
    const auto may_be_on_front = [&](const Standing& s) {
        return !s.measured &&
               std::none_of(standings.begin(), standings.end(), [&s](const Standing& other) {
                   return other.measured && other.ms.value <= s.ms.low &&
                          other.error.value <= s.error.low;
               });
    };
    return leastOf(standings, may_be_on_front, [](const Standing& s) { return s.ms.value; });
}

}  // namespace crevice
