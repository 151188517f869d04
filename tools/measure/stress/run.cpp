// SPDX-License-Identifier: MIT
// Planning the steps of stress cases, and drawing them case by case.
#include "tools/measure/stress/run.h"

#include "tools/measure/line_file.h"
#include "tools/render/image/image_file.h"

#include "core/base/text.h"

#include <nlohmann/json.hpp>

namespace crevice {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StressRecord, config, case_name, step, device, version, refusal,
                                   absent, bad_target, bad_pass, bad_pixels, out_of_range, bad_x,
                                   bad_y, bad_value, background, mean, least, most, stored,
                                   step_share, resolved, judged, judged_mean, judged_least,
                                   judged_below, change, exact, occlusion, rmse, rmse_white,
                                   departing_pass, radius_px, height_px, picture)

namespace {

Result<std::vector<const StressCase*>> chooseCases(const std::vector<std::string>& names)
{
    for (const std::string& name : names)
        if (!findNamed(stressCases(), name))
            return Diagnostic{Code::usage, "there is no case '" + name + "'",
                              suggestName(name, namesOf(stressCases()), "cases")};
    std::vector<const StressCase*> chosen;
    for (const StressCase& each : stressCases())
        if (names.empty() || contains(names, each.name)) chosen.push_back(&each);
    return chosen;
}

/// The ends, the ordinary one, without which they say nothing, and kinds of which each must be the
/// same: between those there is no way from one to the next.
bool isQuick(const StressCase& stress, std::size_t step)
{
    const bool kind = stress.unit.empty() && stress.expectation == Expectation::same;
    return step == 0 || step + 1 == stress.steps.size() || step == stress.ordinary || kind;
}

bool isSameSeries(const StressTask& a, const StressTask& b)
{
    return a.stress == b.stress && a.config.config == b.config.config;
}

/// Pictures of the steps of a case that fail, numbered from `first` on, and their ground truths.
Status keepFailures(const StressCase& stress, const std::string& folder, std::size_t first,
                    std::vector<StressDrawing>& drawn)
{
    std::vector<const StressRecord*> series(stress.steps.size());
    for (const StressDrawing& each : drawn) series[each.record.step] = &each.record;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        StressRecord& record = drawn[i].record;
        const Outcome outcome = judge(stress, series, record.step).outcome;
        const bool ordinary = record.step == static_cast<int>(stress.ordinary);
        const bool fails = outcome == Outcome::breaks || (outcome == Outcome::invalid && ordinary);
        if (!fails || drawn[i].ao.pixels.empty()) continue;
        record.picture = "pictures/" + std::to_string(first + i) + ".png";
        if (Status kept = writePng(folder + "/" + record.picture, drawn[i].ao); !kept) return kept;
        if (drawn[i].ground_truth.pixels.empty()) continue;
        const std::string truth = folder + "/" + truthPictureOf(record);
        if (Status kept = writePng(truth, drawn[i].ground_truth); !kept) return kept;
    }
    return {};
}

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

Result<std::vector<StressTask>> planStress(const StressOptions& options, const SourceSet& sources)
{
    const auto cases = chooseCases(options.cases);
    if (!cases) return cases.diagnostics();
    const std::vector<std::string> configs =
        options.configs.empty() ? configNames(sources) : options.configs;
    std::vector<StressTask> tasks;
    for (const std::string& config : configs) {
        const ConfigOptions chosen = {
            config, options.variant, options.overrides, {}, options.roots};
        const Result<Description> description = loadDescription(chosen, sources);
        if (!description) return description.diagnostics();
        for (const StressCase* stress : *cases) {
            for (std::size_t step = 0; step < stress->steps.size(); ++step)
                if (!options.quick || isQuick(*stress, step))
                    tasks.push_back({chosen, stress, static_cast<int>(step)});
        }
    }
    return tasks;
}

std::string stepTitle(const StressTask& task)
{
    return nameOf(task.config) + ", " + task.stress->name + ", " +
           task.stress->steps[task.step].label;
}

std::string truthPictureOf(const StressRecord& record)
{
    return record.picture.substr(0, record.picture.rfind(".png")) + "_truth.png";
}

Result<std::vector<StressRecord>> runStress(
    const std::vector<StressTask>& tasks, const std::string& folder,
    const std::function<StressDrawing(const StressTask&)>& draw)
{
    std::error_code error;
    std::filesystem::create_directories(folder + "/pictures", error);
    if (error) return Diagnostic{Code::cannot_write, "cannot write '" + folder + "/pictures'"};
    std::vector<StressRecord> records;
    std::string lines;
    for (std::size_t first = 0, end = 0; first < tasks.size(); first = end) {
        std::vector<StressDrawing> drawn;
        for (; end < tasks.size() && isSameSeries(tasks[first], tasks[end]); ++end)
            drawn.push_back(draw(tasks[end]));
        if (const Status kept = keepFailures(*tasks[first].stress, folder, first, drawn); !kept)
            return kept.diagnostics();
        for (StressDrawing& each : drawn) {
            lines += jsonLine(each.record) + "\n";
            records.push_back(std::move(each.record));
        }
    }
    Status written = writeFile(folder + "/stress.jsonl", lines);
    if (written)
        written = writeFile(folder + "/known.jsonl", toLines(standingsOf(seriesOf(records))));
    if (!written) return written.diagnostics();
    return records;
}

std::vector<StressSeries> seriesOf(const std::vector<StressRecord>& records,
                                   const std::vector<StressCase>& cases)
{
    std::vector<StressSeries> all;
    std::map<std::pair<std::string, std::string>, std::size_t> places;
    for (const StressRecord& record : records) {
        const StressCase* const stress = findNamed(cases, record.case_name);
        if (!stress || record.step < 0 || record.step >= static_cast<int>(stress->steps.size()))
            continue;
        const auto [place, is_new] =
            places.emplace(std::pair(record.config, record.case_name), all.size());
        if (is_new) {
            all.push_back({&*stress, record.config, {}});
            all.back().steps.resize(stress->steps.size());
        }
        all[place->second].steps[record.step] = &record;
    }
    return all;
}

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
