// SPDX-License-Identifier: MIT
// From judged series to sentences.
#include "tools/measure/stress/breakdown.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crevice {
namespace {

/// A point, and by what it is the same as others.
struct Found {
    BreakdownPoint point;
    std::string_view cause;
    std::pair<double, double> figures;  ///< Of both steps; the smaller ones break first.
};

double figureOf(const StressCase& stress, const StressCondition& condition,
                const StressRecord& record)
{
    switch (condition.quantity) {
    case Quantity::screens: return record.radius_px / std::max(record.height_px, 1);
    case Quantity::pixels: return record.radius_px;
    case Quantity::label: break;
    }
    return stress.steps[record.step].value;
}

std::string figureText(const StressCase& stress, const StressCondition& condition,
                       const StressRecord& record)
{
    if (condition.quantity == Quantity::label) return stress.steps[record.step].label;
    const double figure = figureOf(stress, condition, record);
    return figure >= 100 && figure < 1e6 ? fixed(figure, 0) : significant(figure, 2);
}

std::string filledIn(std::string_view text, const std::string& figure)
{
    std::string filled(text);
    const std::size_t at = filled.find("{}");
    if (at != std::string::npos) filled.replace(at, 2, figure);
    return filled;
}

Found foundAt(const StressSeries& series, std::size_t step, const Verdict& verdict,
              std::string_view cause)
{
    Found found;
    found.point.config = series.config;
    found.point.stress = series.stress;
    found.point.after = series.steps[step];
    found.point.effect = verdict.effect;
    found.point.why = verdict.why;
    if (verdict.outcome == Outcome::beyond)
        found.point.why += ", more than " + series.steps[step]->stored + " can resolve";
    found.cause = cause;
    return found;
}

/// Whether the step does harm, and more than that of an ordinary picture that is wrong itself.
bool harms(const Verdict& verdict)
{
    return !verdict.effect.empty() && verdict.outcome != Outcome::invalid;
}

/// Keeps the one that breaks first of those that are the same.
void add(Found found, std::vector<Found>& all)
{
    const auto same = std::find_if(all.begin(), all.end(), [&found](const Found& other) {
        return found.point.config == other.point.config &&
               found.point.effect == other.point.effect && found.cause == other.cause;
    });
    if (same == all.end())
        all.push_back(std::move(found));
    else if (found.figures < same->figures)
        *same = std::move(found);
}

/// Returns whether the ordinary step fails by itself, so that there is no more to say.
bool findOrdinary(const StressSeries& series, std::vector<Found>& all)
{
    const std::size_t ordinary = series.stress->ordinary;
    if (!series.steps[ordinary]) return true;
    const Verdict verdict = judge(*series.stress, series.steps, ordinary);
    if (verdict.effect.empty()) return false;
    Found found = foundAt(series, ordinary, verdict, "ordinary");
    if (harms(verdict)) found.point.condition = "in the ordinary picture";
    add(std::move(found), all);
    return harms(verdict);
}

/// The first step of a side that breaks, on the way from the ordinary one.
void findAmount(const StressSeries& series, int direction, std::vector<Found>& all)
{
    const StressCase& stress = *series.stress;
    const StressCondition& condition = direction > 0 ? stress.up : stress.down;
    const StressRecord* before = series.steps[stress.ordinary];
    const int count = static_cast<int>(stress.steps.size());
    for (int i = static_cast<int>(stress.ordinary) + direction; i >= 0 && i < count;
         i += direction) {
        if (!series.steps[i]) continue;
        const Verdict verdict = judge(stress, series.steps, i);
        const bool judged = series.steps[i]->absent.empty() && series.steps[i]->refusal.empty();
        if (judged && !harms(verdict)) before = series.steps[i];
        if (!harms(verdict)) continue;
        Found found = foundAt(series, i, verdict, condition.where);
        found.point.held = figureText(stress, condition, *before);
        found.point.broke = figureText(stress, condition, *series.steps[i]);
        found.point.condition = filledIn(condition.where, found.point.held);
        const double held = figureOf(stress, condition, *before);
        const double broke = figureOf(stress, condition, *series.steps[i]);
        const double sign = broke > held ? 1 : -1;
        found.figures = {sign * held, sign * broke};
        add(std::move(found), all);
        return;
    }
}

/// All kinds that break, those of one effect together: there is no way from one to the next.
void findKinds(const StressSeries& series, std::vector<Found>& all)
{
    const StressCase& stress = *series.stress;
    std::vector<Found> found;
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        if (!series.steps[i] || i == stress.ordinary) continue;
        const Verdict verdict = judge(stress, series.steps, i);
        if (!harms(verdict)) continue;
        const auto same = std::find_if(found.begin(), found.end(), [&](const Found& other) {
            return other.point.effect == verdict.effect;
        });
        if (same == found.end()) {
            found.push_back(foundAt(series, i, verdict, stress.name));
            found.back().point.condition = stress.steps[i].label;
        } else {
            same->point.condition += ", " + stress.steps[i].label;
        }
    }
    for (Found& each : found) {
        each.point.condition = filledIn(stress.up.where, each.point.condition);
        all.push_back(std::move(each));
    }
}

/// "mean 0.93, was 0.91" where a figure moved; empty where not. Figures below 0 are not known.
std::string movedBy(const char* name, double before, double now)
{
    if (before < 0 || now < 0 || std::abs(now - before) <= kSameChange) return "";
    return std::string(name) + " " + significant(now, 4) + ", was " + significant(before, 4);
}

std::string differenceOf(const StressSeries& before, const StressSeries& now, std::size_t step)
{
    const Verdict is = judge(*now.stress, now.steps, step);
    if (judge(*before.stress, before.steps, step).outcome != is.outcome)
        return wordOf(is.outcome) + (is.why.empty() ? "" : ": " + is.reason());
    const StressRecord &old = *before.steps[step], &record = *now.steps[step];
    std::string moved = movedBy("mean", old.mean, record.mean);
    if (moved.empty()) moved = movedBy("rmse", old.rmse, record.rmse);
    if (moved.empty()) moved = movedBy("change", old.change, record.change);
    if (!moved.empty() && !record.departing_pass.empty())
        moved += ", first in pass '" + record.departing_pass + "'";
    return moved;
}

}  // namespace

std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all)
{
    std::vector<Found> found;
    for (const StressSeries& series : all) {
        if (findOrdinary(series, found)) continue;
        if (series.stress->unit.empty()) {
            findKinds(series, found);
            continue;
        }
        findAmount(series, 1, found);
        findAmount(series, -1, found);
    }
    std::vector<BreakdownPoint> points;
    for (Found& each : found) points.push_back(std::move(each.point));
    return points;
}

std::string sentenceOf(const BreakdownPoint& point)
{
    const std::string condition = point.condition.empty() ? "" : " " + point.condition;
    const std::string at = point.broke.empty() ? "" : "at " + point.broke + ", ";
    return "AO of `" + point.config + "` " + point.effect + condition + ": " + at + point.why + ".";
}

std::vector<std::string> differencesSince(const std::vector<StressSeries>& before,
                                          const std::vector<StressSeries>& now)
{
    std::vector<std::string> differences;
    for (const StressSeries& series : now) {
        const auto old =
            std::find_if(before.begin(), before.end(), [&series](const StressSeries& each) {
                return each.stress == series.stress && each.config == series.config;
            });
        for (std::size_t step = 0; old != before.end() && step < series.steps.size(); ++step) {
            if (!series.steps[step] || !old->steps[step]) continue;
            const std::string what = differenceOf(*old, series, step);
            if (!what.empty())
                differences.push_back(series.config + ", " + series.stress->name + ", " +
                                      series.stress->steps[step].label + ": " + what);
        }
    }
    return differences;
}

}  // namespace crevice
