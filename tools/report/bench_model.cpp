// SPDX-License-Identifier: MIT
// Bench points become what a report says.
#include "tools/report/bench_model.h"

#include "tools/bench/choice.h"
#include "tools/bench/curves.h"
#include "tools/bench/pareto.h"
#include "tools/bench/views.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace crevice {
namespace {

using nlohmann::json;
using Points = std::vector<BenchPoint>;

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

double costOf(const BenchPoint& point) { return point.cost.median; }
double ratioOf(const BenchPoint& point) { return point.ratio_copy; }

/// Indexes of the points on the front; no ambient occlusion at all is free and beats some of them.
json frontOf(const Points& points, const ResultView& view, double (*cost)(const BenchPoint&))
{
    std::vector<std::size_t> which;
    std::vector<CostError> figures;
    for (const std::size_t i : view.points) {
        const BenchPoint& point = points[i];
        if (!(cost(point) > 0.0) || point.error.rmse >= point.error_without_ao) continue;
        which.push_back(i);
        figures.push_back({cost(point), point.error.rmse});
    }
    json front = json::array();
    for (const std::size_t i : paretoFront(figures)) front.push_back(which[i]);
    return front;
}

json toJson(const Points& points, const ResultView& view, bool main)
{
    return {{"device", view.device},
            {"scene", view.scene},
            {"camera", view.camera},
            {"name", view.name},
            {"size", extentName(view.extent)},
            {"radius", view.radius},
            {"main", main},
            {"points", view.points},
            {"front_ms", frontOf(points, view, costOf)},
            {"front_ratio", frontOf(points, view, ratioOf)},
            {"error_without_ao", points[view.points.front()].error_without_ao},
            {"curves", toJson(curvesOf(points, view))}};
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
                         {"point", candidate.point},
                         {"ms", candidate.ms},
                         {"ratio", candidate.ratio},
                         {"error", candidate.error},
                         {"slowest_view", candidate.slowest_view},
                         {"worst_view", candidate.worst_view},
                         {"roles", std::move(roles)}});
    }
    return steps;
}

/// Requires a device that has points with figures.
json adviceFor(const Points& points, const std::string& device)
{
    Points own;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].device != device) continue;
        own.push_back(points[i]);
        index.push_back(i);
    }
    const Result<Candidates> candidates = findCandidates(own, {});
    json steps = stepsOf(candidates->list);
    for (json& step : steps) step["point"] = index[step["point"].get<std::size_t>()];
    json views = json::array();
    for (const ResultView& view : candidates->views) views.push_back(view.name);
    const BenchPoint& first = own.front();
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

json failuresOf(const Points& points)
{
    json failures = json::array();
    for (const BenchPoint& point : points) {
        if (point.failure.empty()) continue;
        failures.push_back(
            {{"title", pointLabel(point) + ", " + viewName(point.scene, point.camera) + ", " +
                           extentName(point.extent)},
             {"reason", point.failure}});
    }
    return failures;
}

}  // namespace

json reportModel(const Points& points)
{
    json model = {{"points", json::array()},
                  {"views", json::array()},
                  {"advice", json::array()},
                  {"failures", failuresOf(points)}};
    for (const BenchPoint& point : points) {
        json item = json::parse(toJsonLine(point));
        item["label"] = pointLabel(point);
        model["points"].push_back(std::move(item));
    }
    const std::vector<ResultView> views = benchViews(points);
    std::vector<ResultView> main_views;
    for (const std::string& device : benchDevices(points)) {
        model["advice"].push_back(adviceFor(points, device));
        for (ResultView& view : mainViews(views, device)) main_views.push_back(std::move(view));
    }
    for (const ResultView& view : views) {
        const bool main =
            std::any_of(main_views.begin(), main_views.end(),
                        [&view](const ResultView& other) { return other.points == view.points; });
        model["views"].push_back(toJson(points, view, main));
    }
    return model;
}

}  // namespace crevice
