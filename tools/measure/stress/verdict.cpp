// SPDX-License-Identifier: MIT
// What the figures of a stress case mean.
#include "tools/measure/stress/limits.h"
#include "tools/measure/stress/record.h"

#include "core/base/text.h"

#include <cmath>

namespace crevice {
namespace {

constexpr const char* kOnPlane = "darkens a flat plane";
constexpr const char* kNotValid = "is wrong to begin with";

std::string number(double value) { return significant(value, 4); }

std::string percent(double share) { return std::to_string(std::lround(share * 100)) + " %"; }

Verdict breaks(const char* effect, std::string why)
{
    return {Outcome::breaks, std::move(why), effect};
}

/// Of occlusion that should be 1, as a factor; empty where it is about that.
const char* effectOf(double kept)
{
    return kept < kLeastKept ? "is lost" : kept > kMostKept ? "is too strong" : "";
}

/// Whether the exact answer of a step has occlusion that a picture of its size can show.
bool isShown(const StressRecord& record)
{
    return record.exact >= kLeastExact && record.radius_px >= kLeastRadiusPx;
}

double keptOf(const StressRecord& record) { return record.occlusion / record.exact; }

std::string keptText(const StressRecord& record)
{
    return percent(keptOf(record)) + " of the ground truth's occlusion";
}

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
        return breaks("has values that are not numbers", who + std::to_string(record.bad_pixels) +
                                                             " pixels that are not finite" + where);
    if (record.out_of_range > 0 && !where.empty())
        return breaks("has values out of range", who + std::to_string(record.out_of_range) +
                                                     " pixels out of range" + where + ": " +
                                                     number(record.bad_value));
    if (record.out_of_range > 0)
        return breaks("has values out of range",
                      std::to_string(record.out_of_range) + " pixels out of range, " +
                          number(record.least) + " to " + number(record.most));
    if (record.background < 1 - kSamePixel)
        return breaks("darkens the background",
                      number(record.background) + " where no surface is seen");
    return {};
}

/// Whether the ordinary picture is ambient occlusion, so that what becomes of it says something.
Verdict judgeOrdinary(const StressRecord& record)
{
    if (!isShown(record) || record.rmse < 0) return {};
    const double strength = keptOf(record);
    if (strength < kLeastStrength || strength > kMostStrength)
        return {Outcome::invalid, "the ordinary picture has " + keptText(record), kNotValid};
    const double grey = std::sqrt(record.rmse_white * record.rmse_white -
                                  record.exact * record.exact);  // the truth's deviation
    if (record.rmse < grey) return {};
    return {Outcome::invalid,
            "the ordinary picture is no closer to the ground truth than an even "
            "grey: rmse " +
                number(record.rmse) + ", " + number(grey),
            kNotValid};
}

/// What no step that has a ground truth may lose.
Verdict judgeKept(const StressRecord& record)
{
    if (!isShown(record) || record.rmse < 0) return {};
    if (keptOf(record) >= kLeastKept && keptOf(record) <= kMostKept) return {};
    return breaks(effectOf(keptOf(record)), keptText(record));
}

Verdict judgeOpen(const StressRecord& record)
{
    if (record.judged_mean >= kOpenMean && record.judged_below == 0) return {};
    const std::string share = number(record.judged_below * 100) + " % below 0.95";
    return breaks(kOnPlane, "mean " + number(record.judged_mean) + ", least " +
                                number(record.judged_least) +
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
        if (wrong) {
            const std::string means = "mean " + number(here.mean) + " after " + number(before);
            if (!opens && isShown(here) && here.rmse >= 0)
                return breaks("is lost", keptText(here) + ", " + means);
            return breaks(opens ? "does not fade with the radius" : "does not darken",
                          means + " at " + stress.steps[other].label);
        }
    }
    if (opens && step == 0 && here.mean < kOpenMean)
        return breaks("does not fade with the radius",
                      "mean " + number(here.mean) + " instead of 1");
    return {};
}

/// Detail smaller than a step of the format is lost, so coarse steps cannot leave a picture the
/// same; but they leave occlusion.
Verdict judgeSame(const StressCase& stress, const StressRecord& record)
{
    if (record.step_share <= kFineShare) {
        if (record.change <= stress.limit) return {};
        const bool known = record.exact >= kLeastExact && *effectOf(keptOf(record)) != 0;
        return breaks(known ? effectOf(keptOf(record)) : "changes",
                      "mean change " + number(record.change));
    }
    if (!isShown(record)) return {Outcome::beyond, "mean change " + number(record.change)};
    const double kept = keptOf(record);
    const std::string lost = kept <= 1 ? percent(1 - kept) + " of the occlusion lost"
                                       : percent(kept - 1) + " more occlusion";
    const double most = stress.limit + std::pow(std::sin(kRaises * record.step_share), 2);
    if (record.resolved > 0 && (kept < kLeastKept || record.change > most))
        return breaks(*effectOf(kept) != 0 ? effectOf(kept) : "changes",
                      lost + ", mean change " + number(record.change));
    return {Outcome::beyond, lost + ", mean change " + number(record.change)};
}

/// What is asked of the step of a case, by its expectation.
Verdict judgeExpected(const StressCase& stress, const std::vector<const StressRecord*>& series,
                      std::size_t step)
{
    const StressRecord& record = *series[step];
    const bool resolves = record.resolved > 0;
    switch (stress.expectation) {
    case Expectation::sound: return {};
    case Expectation::one:
        if (record.least == 1 && record.most == 1) return {};
        return breaks("is there where there is none",
                      number(record.least) + " to " + number(record.most) + " instead of 1");
    case Expectation::open:
        if (record.judged == 0 && resolves) return {};  // too small a picture to have a middle
        return resolves ? judgeOpen(record)
                        : Verdict{Outcome::beyond, percent(1 - record.mean) + " false occlusion"};
    case Expectation::same: return judgeSame(stress, record);
    case Expectation::dims:
        if (record.change <= stress.limit) return {};
        return breaks("does not dim the ambient light as it should",
                      "mean change " + number(record.change) +
                          " from the light without occlusion times the occlusion");
    case Expectation::opens:
    case Expectation::darkens: return judgeSlope(stress, series, step);
    case Expectation::settles:
        if (record.change <= stress.limit) return {};
        return breaks("flickers though nothing moves",
                      "the next frame changes " + number(record.change * 100) + " % of the pixels");
    }
    return {};
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
            reach.why = verdict.reason();
            return;
        }
        if (verdict.outcome == Outcome::holds) reach.holds_to = i;
    }
}

/// Of the first step of a side that is more than the format can resolve.
std::string beyondOf(const StressCase& stress, const std::vector<const StressRecord*>& series,
                     int first, int direction)
{
    for (int i = first; i >= 0 && i < static_cast<int>(stress.steps.size()); i += direction) {
        if (!series[i]) continue;
        const Verdict verdict = judge(stress, series, i);
        if (verdict.outcome == Outcome::beyond)
            return "beyond " + series[i]->stored + " at " + atLabel(stress, i) + ": " + verdict.why;
    }
    return "";
}

/// All but the pass that it begins with.
Verdict judgeStep(const StressCase& stress, const std::vector<const StressRecord*>& series,
                  std::size_t step)
{
    const StressRecord& record = *series[step];
    if (!record.absent.empty()) return {Outcome::absent, record.absent};
    if (!record.refusal.empty()) return {Outcome::refused, record.refusal};
    if (const Verdict sound = judgeSoundness(record); sound.outcome != Outcome::holds) return sound;
    const StressRecord* ordinary = series[stress.ordinary];
    const Verdict valid = ordinary ? judgeOrdinary(*ordinary) : Verdict{};
    if (valid.outcome != Outcome::holds && step == stress.ordinary) return valid;
    const Verdict expected = judgeExpected(stress, series, step);
    if (expected.outcome != Outcome::holds) return expected;
    return valid.outcome == Outcome::holds ? judgeKept(record) : valid;
}

}  // namespace

std::string wordOf(Outcome outcome)
{
    const char* const words[] = {"holds", "breaks", "beyond", "refused", "absent", "void"};
    return words[static_cast<int>(outcome)];
}

std::string Verdict::reason() const
{
    return pass.empty() ? why : why + ", first in pass '" + pass + "'";
}

Verdict judge(const StressCase& stress, const std::vector<const StressRecord*>& series,
              std::size_t step)
{
    Verdict verdict = judgeStep(stress, series, step);
    const std::string& pass = series[step]->departing_pass;
    const bool fails = verdict.outcome == Outcome::breaks || verdict.outcome == Outcome::invalid;
    if (fails && !pass.empty() && series[step]->bad_target.empty()) verdict.pass = pass;
    return verdict;
}

Breakdown findBreakdown(const StressCase& stress, const std::vector<const StressRecord*>& series)
{
    Breakdown found;
    found.absent = true;
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        if (!series[i]) continue;
        const Outcome outcome = judge(stress, series, i).outcome;
        if (found.why_absent.empty()) found.why_absent = series[i]->absent;
        found.failures += outcome == Outcome::breaks;
        found.refused += outcome == Outcome::refused;
        if (outcome != Outcome::absent) found.absent = false;
    }
    walk(stress, series, -1, found.down);
    walk(stress, series, 1, found.up);
    const int ordinary = static_cast<int>(stress.ordinary);
    if (series[ordinary])
        if (const Verdict verdict = judge(stress, series, ordinary);
            verdict.outcome == Outcome::invalid) {
            found.invalid = verdict.reason();
            ++found.failures;
        }
    found.beyond = beyondOf(stress, series, ordinary, -1);
    const std::string above = beyondOf(stress, series, ordinary + 1, 1);
    found.beyond += (found.beyond.empty() || above.empty() ? "" : "; ") + above;
    return found;
}

std::string describe(const StressCase& stress, const Breakdown& breakdown)
{
    if (breakdown.absent)
        return "not in this config" +
               (breakdown.why_absent.empty() ? "" : ": " + breakdown.why_absent);
    const Reach &down = breakdown.down, &up = breakdown.up;
    std::vector<std::string> parts;
    if (down.holds_to >= 0 && up.holds_to >= 0)
        parts.push_back(down.holds_to == up.holds_to
                            ? "holds at " + atLabel(stress, up.holds_to)
                            : "holds from " + atLabel(stress, down.holds_to) + " to " +
                                  atLabel(stress, up.holds_to));
    else if (!breakdown.invalid.empty())
        parts.push_back("VOID: " + breakdown.invalid);
    const bool same_break = down.breaks_at == up.breaks_at;
    for (const Reach* reach : {&down, &up})
        if (reach->breaks_at >= 0 && !(same_break && reach == &up))
            parts.push_back("breaks at " + atLabel(stress, reach->breaks_at) + ": " + reach->why);
    if (breakdown.refused > 0) parts.push_back(std::to_string(breakdown.refused) + " refused");
    if (!breakdown.beyond.empty()) parts.push_back(breakdown.beyond);
    return joined(parts, "; ");
}

}  // namespace crevice
