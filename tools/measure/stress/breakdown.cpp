// SPDX-License-Identifier: MIT
// From judged series to sentences.
#include "tools/measure/stress/breakdown.h"

#include "core/base/text.h"

#include <cmath>

namespace crevice {
namespace {

double figureOf(const StressSeries& series, const StressCondition& condition, int step)
{
    const StressRecord& record = *series.steps[step];
    switch (condition.quantity) {
    case Quantity::screens: return record.radius_px / std::max(record.height_px, 1);
    case Quantity::pixels: return record.radius_px;
    case Quantity::label: break;
    }
    return series.stress->steps[step].value;
}

std::string figureText(const StressSeries& series, const StressCondition& condition, int step)
{
    if (condition.quantity == Quantity::label) return series.stress->steps[step].label;
    const double figure = figureOf(series, condition, step);
    return figure >= 100 && figure < 1e6 ? fixed(figure, 0) : significant(figure, 2);
}

std::string filledIn(std::string_view text, const std::string& figure)
{
    std::string filled(text);
    const std::size_t at = filled.find("{}");
    if (at != std::string::npos) filled.replace(at, 2, figure);
    return filled;
}

BreakdownPoint pointAt(const StressSeries& series, int step)
{
    const Verdict verdict = judge(*series.stress, series.steps, step);
    BreakdownPoint point;
    point.config = series.config;
    point.stress = series.stress;
    point.after = series.steps[step];
    point.effect = verdict.effect;
    point.why = verdict.why;
    return point;
}

/// Of those of one config, effect and cause the one whose figures are less is kept: it breaks
/// first.
class Points {
public:
    std::vector<BreakdownPoint> all;

    void add(BreakdownPoint point, std::string_view cause, std::pair<double, double> figures = {})
    {
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].config != point.config || all[i].effect != point.effect ||
                causes_[i] != cause)
                continue;
            if (!(figures < figures_[i])) return;
            all[i] = std::move(point);
            figures_[i] = figures;
            return;
        }
        all.push_back(std::move(point));
        causes_.push_back(cause);
        figures_.push_back(figures);
    }

private:
    std::vector<std::string_view> causes_;
    std::vector<std::pair<double, double>> figures_;
};

void addAmount(const StressSeries& series, const StressCondition& condition, const Reach& reach,
               Points& points)
{
    if (reach.breaks_at < 0) return;
    BreakdownPoint point = pointAt(series, reach.breaks_at);
    const int last = reach.holds_to >= 0 ? reach.holds_to : int(series.stress->ordinary);
    point.held = figureText(series, condition, last);
    point.broke = figureText(series, condition, reach.breaks_at);
    point.condition = filledIn(condition.where, point.held);
    const double held = figureOf(series, condition, last);
    const double broke = figureOf(series, condition, reach.breaks_at);
    const double sign = broke > held ? 1 : -1;
    points.add(std::move(point), condition.where, {sign * held, sign * broke});
}

/// All kinds that break, those of one effect together: there is no way from one to the next.
void addKinds(const StressSeries& series, Points& points)
{
    const StressCase& stress = *series.stress;
    std::vector<BreakdownPoint> found;
    for (std::size_t i = 0; i < stress.steps.size(); ++i) {
        if (!series.steps[i] || judge(stress, series.steps, i).outcome != Outcome::breaks) continue;
        BreakdownPoint point = pointAt(series, static_cast<int>(i));
        point.condition = stress.steps[i].label;
        const auto same = std::find_if(
            found.begin(), found.end(),
            [&point](const BreakdownPoint& other) { return other.effect == point.effect; });
        if (same == found.end())
            found.push_back(std::move(point));
        else
            same->condition += ", " + point.condition;
    }
    for (BreakdownPoint& point : found) {
        point.condition = filledIn(stress.up.where, point.condition);
        points.add(std::move(point), stress.name);
    }
}

void addPoints(const StressSeries& series, Points& points)
{
    const StressCase& stress = *series.stress;
    const int ordinary = static_cast<int>(stress.ordinary);
    const Breakdown found = findBreakdown(stress, series.steps);
    if (!found.invalid.empty()) points.add(pointAt(series, ordinary), "invalid");
    if (found.up.breaks_at == ordinary) {
        BreakdownPoint point = pointAt(series, ordinary);
        point.condition = "in the ordinary picture";
        points.add(std::move(point), "ordinary");
    } else if (stress.unit.empty()) {
        addKinds(series, points);
    } else {
        addAmount(series, stress.up, found.up, points);
        addAmount(series, stress.down, found.down, points);
    }
}

}  // namespace

std::vector<BreakdownPoint> breakdownPoints(const std::vector<StressSeries>& all)
{
    Points points;
    for (const StressSeries& series : all) addPoints(series, points);
    return std::move(points.all);
}

std::string sentenceOf(const BreakdownPoint& point)
{
    const std::string condition = point.condition.empty() ? "" : " " + point.condition;
    const std::string at = point.broke.empty() ? "" : "at " + point.broke + ", ";
    return "AO of `" + point.config + "` " + point.effect + condition + ": " + at + point.why + ".";
}

}  // namespace crevice
