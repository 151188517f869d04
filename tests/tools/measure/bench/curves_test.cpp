// SPDX-License-Identifier: MIT
// Scaling curves: which samples are joined, and the slopes fitted to them.
#include "tools/measure/bench/curves.h"

#include "tests/support/catch.h"
#include "tests/tools/measure/bench/fixture.h"

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

/// A config of which all taps would take ever less.
std::vector<BenchSample> sweep(double slope)
{
    std::vector<BenchSample> samples;
    for (int taps : {64, 4, 16}) {
        samples.push_back(benchSample("a", taps, taps, 0.1));
        samples.back().budget.taps = -0.4 * std::pow(taps, slope);
    }
    return samples;
}

ResultView viewOf(const std::vector<BenchSample>& samples)
{
    ResultView view;
    view.device = samples[0].device;
    view.scene = samples[0].scene;
    view.camera = samples[0].camera;
    view.extent = samples[0].extent;
    view.radius = samples[0].radius;
    for (std::size_t i = 0; i < samples.size(); ++i) view.samples.push_back(i);
    return view;
}

const Curve* curveOf(const std::vector<Curve>& curves, const std::string& kind)
{
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&kind](const Curve& curve) { return curve.kind == kind; });
    return found == curves.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("what all taps would take from the error is a curve over samples")
{
    const std::vector<BenchSample> samples = sweep(-1.0);
    const std::vector<Curve> curves = curvesOf(samples, viewOf(samples));
    const Curve* const taps = curveOf(curves, "taps_samples");
    REQUIRE(taps);
    CHECK(taps->law->slope == Approx(-1.0));
    CHECK(taps->law->scale == Approx(0.4));
    CHECK(taps->points.size() == 3);
    CHECK(taps->points.front().x == 4);
    CHECK(taps->points.front().y == Approx(0.1));
}

TEST_CASE("a sample to whose error taps would add is no point of a curve")
{
    std::vector<BenchSample> samples = sweep(-1.0);
    samples[0].budget.taps = 0.01;
    CHECK(curveOf(curvesOf(samples, viewOf(samples)), "taps_samples")->points.size() == 2);
    samples[1].budget.taps = 0;
    CHECK_FALSE(curveOf(curvesOf(samples, viewOf(samples)), "taps_samples"));
    CHECK(curveOf(curvesOf(samples, viewOf(samples)), "error_samples"));
}

TEST_CASE("kernels with other lengths are curves of their own")
{
    std::vector<BenchSample> samples = sweep(-0.5);
    for (BenchSample& sample : sweep(-1.0)) {
        sample.family = "a /generated/kernel/lengths=linear";
        samples.push_back(sample);
    }
    std::vector<double> slopes;
    for (const Curve& curve : curvesOf(samples, viewOf(samples)))
        if (curve.kind == "taps_samples") slopes.push_back(curve.law->slope);
    REQUIRE(slopes.size() == 2);
    CHECK(slopes[0] == Approx(-0.5));
    CHECK(slopes[1] == Approx(-1.0));
}
