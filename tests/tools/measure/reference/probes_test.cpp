// SPDX-License-Identifier: MIT
// Probes in passes: all of them once, and each pass spread as evenly as so many can be.
#include "tools/measure/reference/probes.h"

#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

using namespace crevice;

namespace {

constexpr double kPi = 3.14159265358979323846;

std::vector<Probe> slice(const ProbePasses& made, int first_pass, int end_pass)
{
    return {made.probes.begin() + made.begins[first_pass],
            made.probes.begin() + made.begins[end_pass]};
}

// How many of columns x rows cells of the disc, of even area, hold none of the probes.
int emptyCells(const std::vector<Probe>& probes, int columns, int rows)
{
    std::set<int> taken;
    for (const Probe& probe : probes) {
        const double turn = std::atan2(probe.sine, probe.cosine) / (2 * kPi) + 1.0 + 1e-6;
        const int column = static_cast<int>(probe.radius_squared * columns);
        taken.insert(column * rows + static_cast<int>((turn - std::floor(turn)) * rows));
    }
    return columns * rows - static_cast<int>(taken.size());
}

}  // namespace

TEST_CASE("passes share out the probes of one pass")
{
    using Numbers = std::tuple<float, float, float>;
    const auto sorted = [](const ProbePasses& made) {
        std::multiset<Numbers> numbers;
        for (const Probe& probe : made.probes)
            numbers.insert({probe.radius_squared, probe.cosine, probe.sine});
        return numbers;
    };
    for (const int count : {1, 7, 64, 100, 256, 1000}) {
        const ProbePasses whole = makeProbes(count, 1);
        CHECK(whole.begins == std::vector<int>{0, count});
        for (int passes = 1; passes <= std::min(count, 64); passes *= 2) {
            const ProbePasses made = makeProbes(count, passes);
            CHECK(sorted(made) == sorted(whole));
            REQUIRE(made.begins.size() == static_cast<std::size_t>(passes) + 1);
            for (int pass = 0; pass < passes; ++pass) {
                const int share = made.begins[pass + 1] - made.begins[pass];
                CHECK(std::abs(share - count / passes) <= 1);
            }
        }
    }
}

TEST_CASE("one pass has its probes from the axis outwards")
{
    const ProbePasses made = makeProbes(100, 1);
    for (int k = 0; k < 100; ++k)
        CHECK(made.probes[k].radius_squared == Approx((k + 0.5) / 100).margin(1e-6));
}

TEST_CASE("a pass has a probe in each cell, however the disc is cut into as many")
{
    const ProbePasses made = makeProbes(1024, 32);
    for (int pass = 0; pass < 32; ++pass)
        for (int columns = 1; columns <= 32; columns *= 2)
            CHECK(emptyCells(slice(made, pass, pass + 1), columns, 32 / columns) == 0);
}

TEST_CASE("the first 2, 4, 8 and 16 passes are spread as evenly together")
{
    const ProbePasses made = makeProbes(256, 16);
    for (int passes = 1; passes <= 16; passes *= 2)
        for (int columns = 1; columns <= 16 * passes; columns *= 2)
            CHECK(emptyCells(slice(made, 0, passes), columns, 16 * passes / columns) == 0);
}

TEST_CASE("a pass of any number of probes is spread over the disc")
{
    for (const int count : {100, 300, 777}) {
        const ProbePasses made = makeProbes(count, 8);
        for (int pass = 0; pass < 8; ++pass)
            CHECK(emptyCells(slice(made, pass, pass + 1), 3, 3) == 0);
    }
}
