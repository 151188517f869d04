// SPDX-License-Identifier: MIT
// Points of the unit cube: where they lie, how evenly, and what that does to the error of a mean.
#include "core/sampling/sequences.h"

#include "core/sampling/generators.h"
#include "tests/support/catch.h"
#include "tools/bench/pareto.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

using namespace crevice;

namespace {

constexpr std::vector<CubePoint> (*kSequences[])(int, unsigned) = {stratifiedPoints,
                                                                   lowDiscrepancyPoints};

/// The stratum of each point along one axis that is cut into `count` equal ones.
std::set<int> strataAlong(const std::vector<CubePoint>& points, std::size_t axis, int count)
{
    std::set<int> strata;
    for (const CubePoint& point : points) strata.insert(int(point[axis] * count));
    return strata;
}

/// The fewest and the most points in the boxes that cut the axes into 2^x, 2^y and 2^z.
std::pair<int, int> pointsInBoxes(const std::vector<CubePoint>& points, int x, int y, int z)
{
    std::vector<int> boxes(std::size_t(1) << (x + y + z));
    for (const CubePoint& p : points) {
        const int column = int(p[0] * (1 << x)), row = int(p[1] * (1 << y));
        const int layer = int(p[2] * (1 << z));
        ++boxes[std::size_t((((layer << y) + row) << x) + column)];
    }
    const auto ends = std::minmax_element(boxes.begin(), boxes.end());
    return {*ends.first, *ends.second};
}

/// An occluder with a soft edge: a function of a sphere whose mean is 0, along direction `turn`.
double occluder(const glm::dvec3& offset, int turn)
{
    const glm::dvec3 direction(std::cos(turn), std::sin(turn), 0.25 * (turn - 4));
    return std::tanh(4.0 * glm::dot(offset, glm::normalize(direction)));
}

/// The rms over seeds and directions of the mean of `occluder` over a kernel.
double integrationError(int count, const std::string& distribution, const std::string& sequence)
{
    constexpr unsigned kSeeds = 100;
    constexpr int kTurns = 9;
    double squares = 0;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        const auto kernel = makeKernel({false, count, distribution, sequence, seed});
        for (int turn = 0; turn < kTurns; ++turn) {
            double sum = 0;
            for (const glm::vec3& offset : *kernel) sum += occluder(offset, turn);
            squares += sum / count * (sum / count);
        }
    }
    return std::sqrt(squares / kSeeds / kTurns);
}

double convergenceSlope(const std::string& distribution, const std::string& sequence)
{
    std::vector<XY> errors;
    for (int count = 4; count <= 128; count *= 2)
        errors.push_back({double(count), integrationError(count, distribution, sequence)});
    return fitPowerLaw(errors)->slope;
}

}  // namespace

TEST_CASE("points lie within the cube for every count and miss its middle")
{
    for (const auto sequence : kSequences)
        for (int count = 1; count <= kMaxSequenceSize; ++count) {
            const std::vector<CubePoint> points = sequence(count, unsigned(count));
            REQUIRE(int(points.size()) == count);
            for (const CubePoint& point : points)
                for (double coordinate : point) {
                    REQUIRE(std::fmod(coordinate * 0x1p25, 2.0) == 1.0);
                    REQUIRE((coordinate > 0.0 && coordinate < 1.0));
                }
        }
}

TEST_CASE("stratified points have a stratum each along each axis for every count")
{
    for (int count = 1; count <= kMaxSequenceSize; ++count)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto points = stratifiedPoints(count, 5);
            REQUIRE(int(strataAlong(points, axis, count).size()) == count);
        }
}

TEST_CASE("low-discrepancy points are the nets that Sobol promised")
{
    for (unsigned seed = 0; seed < 8; ++seed)
        for (int m = 1; m <= 7; ++m) {
            const auto points = lowDiscrepancyPoints(1 << m, seed);
            for (int x = 0; x <= m; ++x)  // one point in each box of a (0, m, 2)-net
                REQUIRE(pointsInBoxes(points, x, m - x, 0) == std::make_pair(1, 1));
            for (int x = 0; x < m; ++x)  // and two in each of a (1, m, 3)-net
                for (int y = 0; x + y < m; ++y)
                    REQUIRE(pointsInBoxes(points, x, y, m - 1 - x - y) == std::make_pair(2, 2));
        }
}

TEST_CASE("points favour no place, alone or together, whatever their count")
{
    constexpr int kSeeds = 20000;
    for (const auto sequence : kSequences)
        for (int count : {1, 3, 7}) {
            CubePoint mean = {}, product = {};
            for (unsigned seed = 0; seed < kSeeds; ++seed)
                for (const CubePoint& point : sequence(count, seed))
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        mean[axis] += point[axis] / kSeeds / count;
                        product[axis] += point[axis] * point[(axis + 1) % 3] / kSeeds / count;
                    }
            for (std::size_t axis = 0; axis < 3; ++axis) {
                CHECK(mean[axis] == Approx(0.5).margin(0.008));
                CHECK(product[axis] == Approx(0.25).margin(0.008));
            }
        }
}

TEST_CASE("a seed gives the same points again and another seed gives others")
{
    for (const auto sequence : kSequences) {
        CHECK(sequence(17, 5) == sequence(17, 5));
        CHECK(sequence(17, 5) != sequence(17, 6));
    }
}

TEST_CASE("error falls with the slope that each sequence is known for")
{
    CHECK(convergenceSlope("uniform", "random") == Approx(-0.5).margin(0.04));
    CHECK(convergenceSlope("uniform", "stratified") < -0.56);
    CHECK(convergenceSlope("uniform", "low_discrepancy") == Approx(-1.0).margin(0.15));
}

TEST_CASE("better sequences err less in every distribution")
{
    for (const std::string& distribution : distributionNames())
        for (int count : {7, 16, 53, 64}) {
            INFO(distribution << " " << count);
            const double random = integrationError(count, distribution, "random");
            CHECK(integrationError(count, distribution, "stratified") < 0.8 * random);
            CHECK(integrationError(count, distribution, "low_discrepancy") < 0.8 * random);
        }
}
