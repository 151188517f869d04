// SPDX-License-Identifier: MIT
// Bench samples become what a report says.
#include "tools/show/report/bench_model.h"

#include "tools/measure/bench/choice.h"
#include "tools/measure/bench/curves.h"
#include "tools/measure/bench/pareto.h"
#include "tools/measure/bench/views.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace crevice {
namespace {

using nlohmann::json;
using Samples = std::vector<BenchSample>;

json toJson(const std::vector<Curve>& curves)
{
    json list = json::array();
    for (const Curve& curve : curves) {
        json points = json::array();
        for (const XY& point : curve.points) points.push_back({point.x, point.y});
        list.push_back({{"kind", curve.kind},
                        {"label", curve.label},
                        {"family", curve.family},
                        {"points", std::move(points)},
                        {"slope", curve.law->slope},
                        {"scale", curve.law->scale}});
    }
    return list;
}

double costOf(const BenchSample& sample) { return sample.cost.median; }
double ratioOf(const BenchSample& sample) { return sample.ratio_copy; }

/// Indexes of the samples on the front; no ambient occlusion at all is free and beats some of them.
json frontOf(const Samples& samples, const ResultView& view, double (*cost)(const BenchSample&))
{
    std::vector<std::size_t> which;
    std::vector<CostError> figures;
    for (const std::size_t i : view.samples) {
        const BenchSample& sample = samples[i];
        if (!(cost(sample) > 0.0) || sample.error.rmse >= sample.error_without_ao) continue;
        which.push_back(i);
        figures.push_back({cost(sample), sample.error.rmse});
    }
    json front = json::array();
    for (const std::size_t i : paretoFront(figures)) front.push_back(which[i]);
    return front;
}

json toJson(const Samples& samples, const ResultView& view, bool main)
{
    return {{"device", view.device},
            {"scene", view.scene},
            {"camera", view.camera},
            {"name", view.name},
            {"size", extentName(view.extent)},
            {"radius", view.radius},
            {"main", main},
            {"bench_samples", view.samples},
            {"front_ms", frontOf(samples, view, costOf)},
            {"front_ratio", frontOf(samples, view, ratioOf)},
            {"error_without_ao", samples[view.samples.front()].error_without_ao},
            {"curves", toJson(curvesOf(samples, view))}};
}

/// The candidates worth taking, by rising cost, with the part each plays.
json stepsOf(const std::vector<Candidate>& list)
{
    std::vector<CostError> figures;
    std::vector<std::size_t> timed;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (!(list[i].ms > 0.0)) continue;
        timed.push_back(i);
        figures.push_back({list[i].ms, list[i].error});
    }
    const std::vector<std::size_t> front = paretoFront(figures);
    json steps = json::array();
    if (front.empty()) return steps;
    const std::size_t balanced = balancedPoint(figures, front);
    for (const std::size_t i : front) {
        const Candidate& candidate = list[timed[i]];
        json roles = json::array();
        if (i == front.front()) roles.push_back("cheapest");
        if (i == balanced) roles.push_back("balanced");
        if (i == front.back()) roles.push_back("most accurate");
        steps.push_back({{"label", candidate.label},
                         {"bench_sample", candidate.sample},
                         {"ms", candidate.ms},
                         {"ratio", candidate.ratio},
                         {"error", candidate.error},
                         {"slowest_view", candidate.slowest_view},
                         {"worst_view", candidate.worst_view},
                         {"roles", std::move(roles)}});
    }
    return steps;
}

/// Requires a device that has samples with figures.
json adviceFor(const Samples& samples, const std::string& device)
{
    Samples own;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].device != device) continue;
        own.push_back(samples[i]);
        index.push_back(i);
    }
    const Result<Candidates> candidates = findCandidates(own, {});
    json steps = stepsOf(candidates->list);
    for (json& step : steps) step["bench_sample"] = index[step["bench_sample"].get<std::size_t>()];
    json views = json::array();
    for (const ResultView& view : candidates->views) views.push_back(view.name);
    const BenchSample& first = own.front();
    return {{"device", device},
            {"software", first.software},
            {"clock", first.clock},
            {"version", first.version},
            {"size", extentName(candidates->views.front().extent)},
            {"views", std::move(views)},
            {"steps", std::move(steps)},
            {"elided", candidates->elided},
            {"harmful", candidates->harmful},
            {"error_without_ao", candidates->error_without_ao},
            {"curves", toJson(curvesAcross(own, candidates->views))}};
}

json failuresOf(const Samples& samples)
{
    json failures = json::array();
    for (const BenchSample& sample : samples) {
        if (sample.failure.empty()) continue;
        failures.push_back(
            {{"title", sampleLabel(sample) + ", " + viewName(sample.scene, sample.camera) + ", " +
                           extentName(sample.extent)},
             {"reason", sample.failure}});
    }
    return failures;
}

}  // namespace

json reportModel(const Samples& samples)
{
    json model = {{"bench_samples", json::array()},
                  {"views", json::array()},
                  {"advice", json::array()},
                  {"failures", failuresOf(samples)}};
    for (const BenchSample& sample : samples) {
        json item = json::parse(toJsonLine(sample));
        item["label"] = sampleLabel(sample);
        model["bench_samples"].push_back(std::move(item));
    }
    const std::vector<ResultView> views = benchViews(samples);
    std::vector<ResultView> main_views;
    for (const std::string& device : benchDevices(samples)) {
        model["advice"].push_back(adviceFor(samples, device));
        for (ResultView& view : mainViews(views, device)) main_views.push_back(std::move(view));
    }
    for (const ResultView& view : views) {
        const bool main =
            std::any_of(main_views.begin(), main_views.end(),
                        [&view](const ResultView& other) { return other.samples == view.samples; });
        model["views"].push_back(toJson(samples, view, main));
    }
    return model;
}

}  // namespace crevice
