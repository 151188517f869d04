// SPDX-License-Identifier: MIT
#include "tools/show/page/engine/parts.h"

#include "core/base/text.h"
#include "tools/commands/cli/load_config.h"

namespace crevice::page {
namespace {

constexpr double kTime_s = 60;
constexpr int kDisturbedMost = 10;

}  // namespace

Status Chooser::begin(Device& device, const Stage& stage, Extent extent, const Json& wanted)
{
    bench_.reset();
    limits_.clear();
    const Result<SceneCamera> camera = stage.camera(wanted.value("camera", ""), extent);
    if (!camera) return camera.diagnostics();
    const std::string budget = wanted.value("budget", "");
    const Result<ChoiceLimit> time = budget.empty() ? ChoiceLimit() : parseBudget(budget);
    if (!time) return time.diagnostics();
    if (!budget.empty()) limits_.push_back(*time);
    const double error = wanted.value("error", 0.0);
    if (error > 0) limits_.push_back({ChoiceLimit::Kind::error, error});
    auto scene = std::make_shared<Scene>(stage.scene());
    const Bounds bounds = scene->bounds();
    view_ = {std::move(scene), bounds, *camera, extent};
    QuickOptions options;
    options.scene = stage.scene().name;
    const double radius = wanted.value("radius", 0.0);
    if (radius > 0) options.overrides = {"radius=" + shortest(static_cast<float>(radius))};
    options.limits = limits_;
    options.whole_front = true;
    options.time_s = kTime_s;
    options.say = [this](const std::string& line) { lines_.push_back(line); };
    bench_ = std::make_unique<QuickBench>(device, view_, sources(), std::move(options));
    return {};
}

TurnTaker* Chooser::due() const
{
    Turns* turns = bench_ ? bench_->turns() : nullptr;
    return turns ? turns->next() : nullptr;
}

Json Chooser::step()
{
    const Result<bool> more = bench_->step();
    const bool ends = more && !*more;
    Json json = ends ? answer(leftOut()) : answer(more);
    json["more"] = more && !ends;
    if (ends) bench_.reset();
    return state(std::move(json));
}

Json Chooser::add(const FrameTimes& times)
{
    Json json = answer(Status());
    json["more"] = true;
    Turns& turns = *bench_->turns();
    disturbed_ = times.total_ms < 0 ? disturbed_ + 1 : 0;
    if (disturbed_ == 0) turns.add(times);
    if (disturbed_ == kDisturbedMost)
        bench_->settle(Diagnostic{Code::gl_error, "the GPU's timer is disturbed"});
    else if (!turns.next())
        bench_->settle({});
    if (!bench_->turns()) json["found"] = found();
    return state(std::move(json));
}

/// What is not among what was found, and why.
Diagnostics Chooser::leftOut() const
{
    Diagnostics all = bench_->warnings();
    if (const auto known = findCandidates(bench_->samples(), {}))
        for (const std::string& label : known->harmful)
            all.push_back(asWarning(
                {Code::out_of_range, label + " is left out: no better than no ambient occlusion"}));
    return all;
}

Json Chooser::state(Json json)
{
    json["due"] = due() != nullptr;
    json["lines"] = std::exchange(lines_, {});
    return json;
}

Json Chooser::found() const
{
    Json list = Json::array();
    const std::vector<BenchSample> samples = bench_->samples();
    const Result<Candidates> all = findCandidates(samples, {});
    if (!all) return list;
    const Result<Choice> choice = choose(*all, limits_);
    const std::vector<std::size_t> front = frontOf(all->list);
    const auto has = [](const std::vector<std::size_t>& places, std::size_t i) {
        return std::find(places.begin(), places.end(), i) != places.end();
    };
    for (std::size_t i = 0; i < all->list.size(); ++i) {
        const Candidate& each = all->list[i];
        const BenchSample& sample = samples[each.sample];
        list.push_back({{"label", each.label},
                        {"config", sample.config},
                        {"overrides", sample.overrides},
                        {"ms", each.ms},
                        {"ratio", each.ratio},
                        {"rmse", each.error},
                        {"margin", bench_->detailsOf(sample).error_margin},
                        {"front", has(front, i)},
                        {"within", choice && has(choice->within, i)},
                        {"best", choice && choice->within.front() == i}});
    }
    std::sort(list.begin(), list.end(),
              [](const Json& a, const Json& b) { return a["ms"] < b["ms"]; });
    return list;
}

Json Chooser::textOf(const Json& found)
{
    LoadRequest request = {found.value("config", "")};
    const Result<Node> base = loadConfig(sources(), request);
    request.overrides = found.value("overrides", std::vector<std::string>());
    Result<Node> now = loadConfig(sources(), request);
    if (!base || !now) return answer(now);
    const auto text = patchText(*base, std::move(*now), {request.config}, sources());
    Json json = answer(text);
    if (text) json["text"] = *text;
    return json;
}

}  // namespace crevice::page
