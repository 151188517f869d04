// SPDX-License-Identifier: MIT
// Two runs of stress, step by step.
#include "tools/measure/stress/differences.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

const char* wordOf(Outcome outcome)
{
    switch (outcome) {
    case Outcome::holds: return "holds";
    case Outcome::breaks: return "breaks";
    case Outcome::beyond: return "is beyond the format";
    case Outcome::refused: return "is refused";
    case Outcome::absent: return "is absent";
    case Outcome::invalid: return "is void";
    }
    return "";
}

/// "mean 0.93, was 0.91" where a figure moved; empty where not. Figures below 0 are not known.
std::string movedBy(const char* name, double before, double now)
{
    if (before < 0 || now < 0 || std::abs(now - before) <= kSameChange) return "";
    return std::string(name) + " " + significant(now, 4) + ", was " + significant(before, 4);
}

std::string differenceOf(const StressSeries& before, const StressSeries& now, std::size_t step)
{
    const Verdict was = judge(*before.stress, before.steps, step);
    const Verdict is = judge(*now.stress, now.steps, step);
    if (was.outcome != is.outcome)
        return std::string(wordOf(is.outcome)) + (is.why.empty() ? "" : ": " + is.reason());
    const StressRecord &old = *before.steps[step], &record = *now.steps[step];
    std::string moved = movedBy("mean", old.mean, record.mean);
    if (moved.empty()) moved = movedBy("rmse", old.rmse, record.rmse);
    if (moved.empty()) moved = movedBy("change", old.change, record.change);
    if (!moved.empty() && !record.departing_pass.empty())
        moved += ", first in pass '" + record.departing_pass + "'";
    return moved;
}

}  // namespace

std::vector<StressDifference> differencesSince(const std::vector<StressSeries>& before,
                                               const std::vector<StressSeries>& now,
                                               std::size_t& missing)
{
    std::vector<StressDifference> differences;
    missing = 0;
    for (const StressSeries& series : now) {
        const auto old =
            std::find_if(before.begin(), before.end(), [&series](const StressSeries& each) {
                return each.stress == series.stress && each.config == series.config &&
                       each.format == series.format;
            });
        for (std::size_t step = 0; step < series.steps.size(); ++step) {
            if (!series.steps[step]) continue;
            if (old == before.end() || !old->steps[step]) {
                ++missing;
                continue;
            }
            std::string what = differenceOf(*old, series, step);
            if (what.empty()) continue;
            differences.push_back({series.config + ", " + seriesName(series) + ", " +
                                       series.stress->steps[step].label,
                                   std::move(what)});
        }
    }
    return differences;
}

}  // namespace crevice
