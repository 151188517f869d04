// SPDX-License-Identifier: MIT
// What the figures of a stress case mean.
#include "tools/stress/record.h"

#include "core/base/numbers.h"

#include <algorithm>

namespace crevice {
namespace {

constexpr double kOpenMean = 0.999;

/// Steps of the format that a picture does not show, in radii.
constexpr double kFineShare = 0.02;
/// What is allowed of coarser ones.
constexpr double kChangePerStep = 0.25;

std::string number(double value) { return significant(value, 4); }

Verdict breaks(std::string why) { return {Outcome::breaks, std::move(why)}; }

/// What is asked of every step.
Verdict judgeSoundness(const StressRecord& record)
{
    const std::string where = record.bad_target.empty()
                                  ? ""
                                  : " into '" + record.bad_target + "', the first at (" +
                                        std::to_string(record.bad_x) + ", " +
                                        std::to_string(record.bad_y) + ")";
    const std::string who = "pass '" + record.bad_pass + "' writes ";
    if (record.bad_pixels > 0)
        return breaks(who + std::to_string(record.bad_pixels) + " pixels that are not finite" +
                      where);
    if (record.out_of_range > 0 && !where.empty())
        return breaks(who + std::to_string(record.out_of_range) + " pixels out of range" + where +
                      ": " + number(record.bad_value));
    if (record.out_of_range > 0)
        return breaks(std::to_string(record.out_of_range) + " pixels out of range, " +
                      number(record.least) + " to " + number(record.most));
    return {};
}

Verdict judgeOpen(const StressRecord& record)
{
    if (record.judged_mean >= kOpenMean && record.judged_below == 0) return {};
    const std::string share = number(record.judged_below * 100) + " % below 0.95";
    return breaks("mean " + number(record.judged_mean) + ", least " + number(record.judged_least) +
                  (record.judged_below > 0 ? ", " + share : ""));
}

/// Against the step before, on the way from `step` to the ordinary one or to the first.
Verdict judgeSlope(const StressCase& stress, const std::vector<const StressRecord*>& series,
                   std::size_t step)
{
    const bool opens = stress.expectation == Expectation::opens;
    const StressRecord& here = *series[step];
    const std::size_t other = opens ? step + 1 : step - 1;
    const bool has_other = (opens ? step < stress.ordinary : step > 0) && series[other] &&
                           series[other]->absent.empty() && series[other]->refusal.empty();
    if (has_other) {
        const double before = series[other]->mean;
        const bool wrong =
            opens ? here.mean < before - stress.limit : here.mean > before + stress.limit;
        if (wrong)
            return breaks("mean " + number(here.mean) + " after " + number(before) + " at " +
                          stress.steps[other].label);
    }
    if (opens && step == 0 && here.mean < kOpenMean)
        return breaks("mean " + number(here.mean) + " instead of 1");
    return {};
}

/// How much a picture may change on average and be the same: the case's limit, where the format's
/// steps are fine; noise of coarser ones showed changes of 0.08 of a step by hemispheres, 0.15 by
/// horizons and 0.24 by normals rebuilt from depth.
double mostChange(const StressCase& stress, const StressRecord& record)
{
    return record.step_share <= kFineShare
               ? stress.limit
               : std::max(stress.limit, kChangePerStep * record.step_share);
}

std::string atLabel(const StressCase& stress, int step) { return stress.steps[step].label; }

void walk(const StressCase& stress, const std::vector<const StressRecord*>& series, int direction,
          Reach& reach)
{
    const int count = static_cast<int>(stress.steps.size());
    for (int i = static_cast<int>(stress.ordinary); i >= 0 && i < count; i += direction) {
        if (!series[i]) continue;
        const Verdict verdict = judge(stress, series, i);
        if (verdict.outcome == Outcome::breaks) {
            reach.breaks_at = i;
            reach.why = verdict.why;
            return;
        }
        if (verdict.outcome == Outcome::holds) reach.holds_to = i;
    }
}

std::string breakText(const StressCase& stress, const Reach& reach)
{
    return "breaks at " + atLabel(stress, reach.breaks_at) + ": " + reach.why;
}

}  // namespace

Verdict judge(const StressCase& stress, const std::vector<const StressRecord*>& series,
              std::size_t step)
{
    const StressRecord& record = *series[step];
    if (!record.absent.empty()) return {Outcome::absent, record.absent};
    if (!record.refusal.empty()) return {Outcome::refused, record.refusal};
    if (const Verdict sound = judgeSoundness(record); sound.outcome != Outcome::holds) return sound;
    const bool resolves = record.resolved > 0;
    switch (stress.expectation) {
    case Expectation::sound: return {};
    case Expectation::one:
        if (record.least == 1 && record.most == 1) return {};
        return breaks(number(record.least) + " to " + number(record.most) + " instead of 1");
    case Expectation::open:
        if (record.judged == 0 && resolves) return {};  // too small a picture to have a middle
        return resolves ? judgeOpen(record) : Verdict{Outcome::beyond, "beyond the format"};
    case Expectation::same:
        if (!resolves) return {Outcome::beyond, "beyond the format"};
        if (record.change <= mostChange(stress, record)) return {};
        return breaks("mean change " + number(record.change));
    case Expectation::opens:
    case Expectation::darkens: return judgeSlope(stress, series, step);
    }
    return {};
}

Breakdown findBreakdown(const StressCase& stress, const std::vector<const StressRecord*>& series)
{
    Breakdown found;
    found.absent = true;
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        if (!series[i]) continue;
        const Outcome outcome = judge(stress, series, i).outcome;
        found.failures += outcome == Outcome::breaks;
        found.refused += outcome == Outcome::refused;
        if (outcome != Outcome::absent) found.absent = false;
    }
    walk(stress, series, -1, found.down);
    walk(stress, series, 1, found.up);
    return found;
}

std::string describe(const StressCase& stress, const Breakdown& breakdown)
{
    if (breakdown.absent) return "not in this config";
    const Reach &down = breakdown.down, &up = breakdown.up;
    std::string text;
    if (down.holds_to >= 0 && up.holds_to >= 0)
        text = down.holds_to == up.holds_to ? "holds at " + atLabel(stress, up.holds_to)
                                            : "holds from " + atLabel(stress, down.holds_to) +
                                                  " to " + atLabel(stress, up.holds_to);
    const bool same_break = down.breaks_at == up.breaks_at;
    for (const Reach* reach : {&down, &up})
        if (reach->breaks_at >= 0 && !(same_break && reach == &up))
            text += (text.empty() ? "" : "; ") + breakText(stress, *reach);
    if (breakdown.refused > 0)
        text += (text.empty() ? "" : "; ") + std::to_string(breakdown.refused) + " refused";
    return text.empty() ? "beyond the format" : text;
}

}  // namespace crevice
