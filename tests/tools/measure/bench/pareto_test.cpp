// SPDX-License-Identifier: MIT
// Pareto fronts against their definition, power laws on points that follow one.
#include "tools/measure/bench/pareto.h"

#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace crevice;

namespace {

bool beats(const CostError& a, const CostError& b)
{
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

std::vector<CostError> randomPoints(unsigned seed, std::size_t count)
{
    std::mt19937 random(seed);
    std::vector<CostError> points(count);
    for (CostError& point : points)  // few values, so that equals come up
        point = {1.0 + random() % 12, 1.0 + random() % 12};
    return points;
}

}  // namespace

TEST_CASE("a Pareto front is what nothing beats, each figure once, by rising cost")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        const std::vector<CostError> points = randomPoints(seed, 1 + seed);
        const std::vector<std::size_t> front = paretoFront(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool beaten = std::any_of(points.begin(), points.end(), [&](const CostError& p) {
                return beats(p, points[i]);
            });
            const bool present = std::any_of(front.begin(), front.end(), [&](std::size_t k) {
                return points[k].cost == points[i].cost && points[k].error == points[i].error;
            });
            CHECK(present == !beaten);
        }
        for (std::size_t k = 1; k < front.size(); ++k) {
            CHECK(points[front[k]].cost > points[front[k - 1]].cost);
            CHECK(points[front[k]].error < points[front[k - 1]].error);
        }
    }
}

TEST_CASE("of equal points the first is on the front, and none that is not finite")
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(paretoFront({{2, 2}, {2, 2}, {nan, 0}, {0, nan}}) == std::vector<std::size_t>{0});
    CHECK(paretoFront({}).empty());
}

TEST_CASE("the balanced point is the knee of a front")
{
    const std::vector<CostError> points = {{1, 10}, {2, 3}, {4, 2.5}, {16, 2}};
    CHECK(balancedPoint(points, paretoFront(points)) == 1);
    const std::vector<CostError> single = {{1, 1}};
    CHECK(balancedPoint(single, paretoFront(single)) == 0);
    const std::vector<CostError> steep = {{10, 2}, {11, 1}}, shallow = {{10, 2}, {30, 1}};
    CHECK(balancedPoint(steep, paretoFront(steep)) == 1);
    CHECK(balancedPoint(shallow, paretoFront(shallow)) == 0);
}

TEST_CASE("a power law is recovered from points that follow it")
{
    for (const double slope : {-1.0, -0.5, 0.0, 1.3}) {
        std::vector<XY> points;
        for (const double x : {4.0, 8.0, 16.0, 64.0})
            points.push_back({x, 0.3 * std::pow(x, slope)});
        const auto law = fitPowerLaw(points);
        REQUIRE(law.has_value());
        CHECK(law->slope == Approx(slope).margin(1e-12));
        CHECK(law->scale == Approx(0.3));
    }
}

TEST_CASE("a fitted slope lies between those of its noisy points")
{
    const auto law = fitPowerLaw({{1, 1}, {2, 2.2}, {4, 3.8}});
    REQUIRE(law.has_value());
    CHECK(law->slope > std::log2(3.8 / 2.2));
    CHECK(law->slope < std::log2(2.2));
}

TEST_CASE("no power law goes through one place, and none through zero")
{
    CHECK(!fitPowerLaw({}).has_value());
    CHECK(!fitPowerLaw({{4, 1}, {4, 2}}).has_value());
    CHECK(!fitPowerLaw({{0, 1}, {4, 2}, {8, -1}}).has_value());
    CHECK(fitPowerLaw({{0, 1}, {4, 2}, {8, 4}})->slope == Approx(1));
}
