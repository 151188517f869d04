// SPDX-License-Identifier: MIT
// Scaling curves of bench points.
#include "tools/bench/curves.h"

#include <algorithm>

namespace crevice {
namespace {

using Figure = double (*)(const BenchPoint&);

double samplesOf(const BenchPoint& point) { return point.samples; }
double pixelsOf(const BenchPoint& point) { return 1.0 * point.extent.width * point.extent.height; }
double radiusOf(const BenchPoint& point) { return point.radius_px; }
double trianglesOf(const BenchPoint& point) { return static_cast<double>(point.triangles); }
double costOf(const BenchPoint& point) { return point.cost.median; }
double totalOf(const BenchPoint& point) { return point.total.median; }
double errorOf(const BenchPoint& point) { return point.error.rmse; }
double samplingOf(const BenchPoint& point) { return point.budget.sampling; }
double noiseOf(const BenchPoint& point) { return point.budget.noise; }

std::string familyOf(const BenchPoint& point) { return point.family; }

struct Axes {
    const char* kind;
    std::string (*label)(const BenchPoint&);
    Figure x;
    Figure y;
};

constexpr Axes kErrorSamples{"error_samples", familyOf, samplesOf, errorOf};
constexpr Axes kSamplingSamples{"sampling_samples", familyOf, samplesOf, samplingOf};
constexpr Axes kNoiseSamples{"noise_samples", familyOf, samplesOf, noiseOf};
constexpr Axes kCostSamples{"cost_samples", familyOf, samplesOf, costOf};
constexpr Axes kCostPixels{"cost_pixels", pointLabel, pixelsOf, costOf};
constexpr Axes kCostRadius{"cost_radius", pointLabel, radiusOf, costOf};
constexpr Axes kCostTriangles{"cost_triangles", pointLabel, trianglesOf, totalOf};

void addPoint(std::vector<Curve>& curves, const Axes& axes, const BenchPoint& point)
{
    const XY at{axes.x(point), axes.y(point)};
    if (!(at.x > 0.0) || !(at.y > 0.0)) return;  // a log scale has no place for it
    const std::string label = axes.label(point);
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&label](const Curve& c) { return c.label == label; });
    if (curve == curves.end())
        curve = curves.insert(curves.end(), {axes.kind, label, point.family, {}, {}});
    curve->points.push_back(at);
}

/// Leaves out what is no curve and appends the rest.
void finish(std::vector<Curve> curves, std::vector<Curve>& all)
{
    for (Curve& curve : curves) {
        curve.law = fitPowerLaw(curve.points);
        if (!curve.law) continue;
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const XY& a, const XY& b) { return a.x < b.x; });
        all.push_back(std::move(curve));
    }
}

void addCurves(const std::vector<BenchPoint>& points, const std::vector<std::size_t>& which,
               const Axes& axes, std::vector<Curve>& all)
{
    std::vector<Curve> curves;
    for (const std::size_t i : which) addPoint(curves, axes, points[i]);
    finish(std::move(curves), all);
}

template <class Condition>
std::vector<std::size_t> pointsAlong(const std::vector<BenchPoint>& points, const ResultView& view,
                                     Condition condition)
{
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const BenchPoint& point = points[i];
        if (point.failure.empty() && point.device == view.device && point.scene == view.scene &&
            point.camera == view.camera && condition(point))
            which.push_back(i);
    }
    return which;
}

}  // namespace

std::vector<Curve> curvesOf(const std::vector<BenchPoint>& points, const ResultView& view)
{
    std::vector<Curve> curves;
    for (const Axes& axes : {kErrorSamples, kSamplingSamples, kNoiseSamples, kCostSamples})
        addCurves(points, view.points, axes, curves);
    const auto same_radius = [&view](const BenchPoint& p) { return p.radius == view.radius; };
    const auto same_extent = [&view](const BenchPoint& p) { return p.extent == view.extent; };
    addCurves(points, pointsAlong(points, view, same_radius), kCostPixels, curves);
    addCurves(points, pointsAlong(points, view, same_extent), kCostRadius, curves);
    return curves;
}

std::vector<Curve> curvesAcross(const std::vector<BenchPoint>& points,
                                const std::vector<ResultView>& main_views)
{
    std::vector<std::size_t> which;
    for (const ResultView& view : main_views)
        which.insert(which.end(), view.points.begin(), view.points.end());
    std::vector<Curve> curves;
    addCurves(points, which, kCostTriangles, curves);
    return curves;
}

}  // namespace crevice
