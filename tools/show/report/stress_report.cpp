// SPDX-License-Identifier: MIT
// The figures of a stress run as its page reads them.
#include "tools/show/report/stress_report.h"

#include "tools/measure/stress/breakdown.h"
#include "tools/show/report/page.h"
#include "tools/show/report/page_data.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace crevice {
namespace {

using nlohmann::json;

/// What the curve of a case shows: how far a step is off what must come out.
double figureOf(const StressCase& stress, const StressRecord& record)
{
    switch (stress.expectation) {
    case Expectation::open: return 1 - record.judged_mean;
    case Expectation::same: return record.change;
    case Expectation::one: return 1 - record.least;
    default: return 1 - record.mean;
    }
}

const char* figureName(const StressCase& stress)
{
    switch (stress.expectation) {
    case Expectation::open: return "occlusion of the plane, mean";
    case Expectation::same: return "change, mean";
    case Expectation::one: return "most occlusion";
    default: return "occlusion, mean";
    }
}

double limitOf(const StressCase& stress)
{
    if (stress.expectation == Expectation::open) return 1 - kOpenMean;
    return stress.expectation == Expectation::same ? stress.limit : 0;
}

json caseModel(const StressCase& stress)
{
    json steps = json::array();
    for (const StressStep& step : stress.steps) steps.push_back(step.label);
    return {{"name", stress.name},         {"what", stress.what},
            {"unit", stress.unit},         {"steps", steps},
            {"ordinary", stress.ordinary}, {"figure", figureName(stress)},
            {"limit", limitOf(stress)}};
}

class Model {
public:
    explicit Model(const std::string& folder) : folder_(folder) {}

    json stepModel(const StressSeries& series, std::size_t step)
    {
        const StressRecord* record = series.steps[step];
        if (!record) return nullptr;
        const Verdict verdict = judge(*series.stress, series.steps, step);
        if (!record->picture.empty()) keepPicture(record->picture);
        return {{"outcome", wordOf(verdict.outcome)},
                {"why", verdict.reason()},
                {"figure", figureOf(*series.stress, *record)},
                {"mean", record->mean},
                {"least", record->least},
                {"share", record->step_share},
                {"stored", record->stored},
                {"radius_px", record->radius_px},
                {"exact", record->exact},
                {"occlusion", record->occlusion},
                {"rmse", record->rmse},
                {"rmse_white", record->rmse_white},
                {"picture", record->picture}};
    }

    json seriesModel(const StressSeries& series)
    {
        const Breakdown found = findBreakdown(*series.stress, series.steps);
        json steps = json::array();
        for (std::size_t i = 0; i < series.steps.size(); ++i) steps.push_back(stepModel(series, i));
        const char* state = found.absent             ? "absent"
                            : !found.invalid.empty() ? "void"
                            : found.failures > 0     ? "breaks"
                            : !found.beyond.empty()  ? "beyond"
                            : found.refused > 0      ? "refused"
                                                     : "holds";
        return {{"config", series.config}, {"case", series.stress->name},
                {"state", state},          {"text", describe(*series.stress, found)},
                {"beyond", found.beyond},  {"steps", steps}};
    }

    /// A picture beside others.
    json shown(const std::string& caption, const std::string& path)
    {
        keepPicture(path);
        return {{"caption", caption}, {"picture", path}};
    }

    json pointModel(const BreakdownPoint& point)
    {
        const std::string label = point.stress->steps[point.after->step].label;
        return {{"config", point.config},
                {"text", sentenceOf(point)},
                {"pictures",
                 {shown(label, point.after->picture),
                  shown("ground truth of that", truthPictureOf(*point.after))}}};
    }

    json take() { return std::move(pictures_); }

private:
    void keepPicture(const std::string& path)
    {
        std::string uri = pictureUri(folder_ + "/" + path, folder_);
        if (!uri.empty()) pictures_[path] = std::move(uri);
    }

    const std::string& folder_;
    json pictures_ = json::object();
};

}  // namespace

std::string stressHtml(const std::vector<StressRecord>& records, const std::string& folder)
{
    Model model(folder);
    json series = json::array(), points = json::array();
    const std::vector<StressSeries> all = seriesOf(records);
    for (const StressSeries& each : all) series.push_back(model.seriesModel(each));
    for (const BreakdownPoint& each : breakdownPoints(all))
        points.push_back(model.pointModel(each));
    json cases = json::array();
    for (const StressCase& each : stressCases()) cases.push_back(caseModel(each));
    std::set<std::string> devices, versions;
    for (const StressRecord& record : records) {
        devices.insert(record.device);
        versions.insert(record.version);
    }
    const json page = {{"devices", devices},      {"versions", versions}, {"cases", cases},
                       {"series", series},        {"points", points},     {"steps", records.size()},
                       {"pictures", model.take()}};
    return pageWith(stressPage(), page);
}

}  // namespace crevice
