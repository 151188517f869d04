// SPDX-License-Identifier: MIT
// Scaling curves: which points join, and the slopes fitted to them.
#include "tools/bench/curves.h"

#include "tests/support/catch.h"
#include "tests/tools/bench/fixture.h"

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

/// A config whose noise falls with one slope before the filter and with another after it.
std::vector<BenchPoint> sweep(double sampling_slope, double noise_slope)
{
    std::vector<BenchPoint> points;
    for (int samples : {64, 4, 16}) {
        points.push_back(benchPoint("a", samples, samples, 0.1));
        points.back().budget.sampling = 0.4 * std::pow(samples, sampling_slope);
        points.back().budget.noise = 0.2 * std::pow(samples, noise_slope);
    }
    return points;
}

ResultView viewOf(const std::vector<BenchPoint>& points)
{
    ResultView view;
    view.device = points[0].device;
    view.scene = points[0].scene;
    view.camera = points[0].camera;
    view.extent = points[0].extent;
    view.radius = points[0].radius;
    for (std::size_t i = 0; i < points.size(); ++i) view.points.push_back(i);
    return view;
}

const Curve* curveOf(const std::vector<Curve>& curves, const std::string& kind)
{
    const auto found = std::find_if(curves.begin(), curves.end(),
                                    [&kind](const Curve& curve) { return curve.kind == kind; });
    return found == curves.end() ? nullptr : &*found;
}

}  // namespace

TEST_CASE("noise before and after the filter are curves over samples, each with its own slope")
{
    const std::vector<BenchPoint> points = sweep(-1.0, -0.5);
    const std::vector<Curve> curves = curvesOf(points, viewOf(points));
    const Curve* const sampling = curveOf(curves, "sampling_samples");
    const Curve* const noise = curveOf(curves, "noise_samples");
    REQUIRE(sampling);
    REQUIRE(noise);
    CHECK(sampling->law->slope == Approx(-1.0));
    CHECK(sampling->law->scale == Approx(0.4));
    CHECK(noise->law->slope == Approx(-0.5));
    CHECK(sampling->points.size() == 3);
    CHECK(sampling->points.front().x == 4);
    CHECK(sampling->points.front().y == Approx(0.1));
}

TEST_CASE("noise that was not measured is no point of a curve")
{
    std::vector<BenchPoint> points = sweep(-1.0, -0.5);
    points[0].budget.sampling = -1;
    CHECK(curveOf(curvesOf(points, viewOf(points)), "sampling_samples")->points.size() == 2);
    points[1].budget.sampling = -1;
    CHECK_FALSE(curveOf(curvesOf(points, viewOf(points)), "sampling_samples"));
    CHECK(curveOf(curvesOf(points, viewOf(points)), "noise_samples"));
}

TEST_CASE("kernels with another distribution are curves of their own")
{
    std::vector<BenchPoint> points = sweep(-0.5, -0.5);
    for (BenchPoint& point : sweep(-1.0, -0.5)) {
        point.family = "a /generated/kernel/distribution=linear";
        points.push_back(point);
    }
    std::vector<double> slopes;
    for (const Curve& curve : curvesOf(points, viewOf(points)))
        if (curve.kind == "sampling_samples") slopes.push_back(curve.law->slope);
    REQUIRE(slopes.size() == 2);
    CHECK(slopes[0] == Approx(-0.5));
    CHECK(slopes[1] == Approx(-1.0));
}
