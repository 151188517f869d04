// SPDX-License-Identifier: MIT
// Scaling curves of bench samples.
#include "tools/measure/bench/curves.h"

#include <algorithm>

namespace crevice {
namespace {

using Figure = double (*)(const BenchSample&);

double samplesOf(const BenchSample& sample) { return sample.samples; }
double pixelsOf(const BenchSample& sample)
{
    return 1.0 * sample.extent.width * sample.extent.height;
}
double radiusOf(const BenchSample& sample) { return sample.radius_px; }
double trianglesOf(const BenchSample& sample) { return static_cast<double>(sample.triangles); }
double costOf(const BenchSample& sample) { return sample.cost.median; }
double totalOf(const BenchSample& sample) { return sample.total.median; }
double errorOf(const BenchSample& sample) { return sample.error.rmse; }
double tapsOf(const BenchSample& sample) { return -sample.budget.taps; }

std::string familyOf(const BenchSample& sample) { return sample.family; }

struct Axes {
    const char* kind;
    std::string (*label)(const BenchSample&);
    Figure x;
    Figure y;
};

constexpr Axes kErrorSamples{"error_samples", familyOf, samplesOf, errorOf};
constexpr Axes kTapsSamples{"taps_samples", familyOf, samplesOf, tapsOf};
constexpr Axes kCostSamples{"cost_samples", familyOf, samplesOf, costOf};
constexpr Axes kCostPixels{"cost_pixels", sampleLabel, pixelsOf, costOf};
constexpr Axes kCostRadius{"cost_radius", sampleLabel, radiusOf, costOf};
constexpr Axes kCostTriangles{"cost_triangles", sampleLabel, trianglesOf, totalOf};

void addSample(std::vector<Curve>& curves, const Axes& axes, const BenchSample& sample)
{
    const XY at{axes.x(sample), axes.y(sample)};
    if (!(at.x > 0.0) || !(at.y > 0.0)) return;  // a log scale has no place for it
    const std::string label = axes.label(sample);
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&label](const Curve& c) { return c.label == label; });
    if (curve == curves.end())
        curve = curves.insert(curves.end(), {axes.kind, label, sample.family, {}, {}});
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

void addCurves(const std::vector<BenchSample>& samples, const std::vector<std::size_t>& which,
               const Axes& axes, std::vector<Curve>& all)
{
    std::vector<Curve> curves;
    for (const std::size_t i : which) addSample(curves, axes, samples[i]);
    finish(std::move(curves), all);
}

template <class Condition>
std::vector<std::size_t> samplesAlong(const std::vector<BenchSample>& samples,
                                      const ResultView& view, Condition condition)
{
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const BenchSample& sample = samples[i];
        if (sample.failure.empty() && sample.device == view.device && sample.scene == view.scene &&
            sample.camera == view.camera && condition(sample))
            which.push_back(i);
    }
    return which;
}

}  // namespace

std::vector<Curve> curvesOf(const std::vector<BenchSample>& samples, const ResultView& view)
{
    std::vector<Curve> curves;
    for (const Axes& axes : {kErrorSamples, kTapsSamples, kCostSamples})
        addCurves(samples, view.samples, axes, curves);
    const auto same_radius = [&view](const BenchSample& p) { return p.radius == view.radius; };
    const auto same_extent = [&view](const BenchSample& p) { return p.extent == view.extent; };
    addCurves(samples, samplesAlong(samples, view, same_radius), kCostPixels, curves);
    addCurves(samples, samplesAlong(samples, view, same_extent), kCostRadius, curves);
    return curves;
}

std::vector<Curve> curvesAcross(const std::vector<BenchSample>& samples,
                                const std::vector<ResultView>& main_views)
{
    std::vector<std::size_t> which;
    for (const ResultView& view : main_views)
        which.insert(which.end(), view.samples.begin(), view.samples.end());
    std::vector<Curve> curves;
    addCurves(samples, which, kCostTriangles, curves);
    return curves;
}

}  // namespace crevice
