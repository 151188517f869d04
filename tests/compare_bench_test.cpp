// SPDX-License-Identifier: MIT
// The regression guard: errors and ratios count, absolute times do not.
#include "tools/compare_bench.h"

#include "tests/bench_fixture.h"
#include "tests/catch.h"

using namespace crevice;

namespace {

const BenchPoint kBefore = benchPoint("a", 16, 2, 0.1);

BenchComparison compared(const BenchPoint& now, const BenchLimits& limits = {})
{
    return compareBenches({kBefore}, {now}, limits);
}

}  // namespace

TEST_CASE("a bench is no worse than itself, nor where times alone are others")
{
    BenchPoint now = kBefore;
    now.total.median *= 10;
    now.key = "another";
    now.version = "1.1";
    const BenchComparison comparison = compared(now);
    CHECK(comparison.compared == 1);
    CHECK(comparison.worse.empty());
    CHECK(comparison.better.empty());
}

TEST_CASE("more error than the limit is worse, less is better")
{
    BenchPoint now = kBefore;
    now.error.rmse += 0.00009;
    CHECK(compared(now).worse.empty());
    now.error.rmse = kBefore.error.rmse + 0.0002;
    REQUIRE(compared(now).worse.size() == 1);
    CHECK(compared(now).worse[0].figure == "rmse");
    CHECK(compared(now).worse[0].point == "a samples=16, room, 960x540");
    CHECK(compared(now, {0.001, 0.15}).worse.empty());
    now.error.rmse = kBefore.error.rmse - 0.0002;
    CHECK(compared(now).worse.empty());
    CHECK(compared(now).better.size() == 1);
}

TEST_CASE("a bias that grows is worse in either direction")
{
    BenchPoint now = kBefore;
    now.error.bias = -kBefore.error.bias + 0.01;
    REQUIRE(compared(now).worse.size() == 1);
    now.error.bias = kBefore.error.bias - 0.01;
    CHECK(compared(now).worse.size() == 1);
}

TEST_CASE("a cost ratio is worse beyond its share")
{
    BenchPoint now = kBefore;
    now.ratio_floor *= 1.14;
    CHECK(compared(now).worse.empty());
    now.ratio_floor = kBefore.ratio_floor * 1.16;
    now.ratio_learnopengl = kBefore.ratio_learnopengl / 1.16;
    REQUIRE(compared(now).worse.size() == 1);
    CHECK(compared(now).worse[0].figure == "ratio_floor");
    CHECK(compared(now).better.size() == 1);
    CHECK(compared(now, {1e-4, 0.2}).worse.empty());
    now.ratio_floor = 0;
    CHECK(compared(now).worse.empty());
}

TEST_CASE("on another device errors are compared and ratios are not")
{
    BenchPoint now = kBefore;
    now.device = "device B";
    now.ratio_floor *= 5;
    CHECK(compared(now).worse.empty());
    CHECK(compared(now).without_ratios == 1);
    now.error.rmse += 0.1;
    CHECK(compared(now).worse.size() == 1);
    CHECK(compareBenches({kBefore}, {now, kBefore}).worse.empty());
}

TEST_CASE("what fails now counts, and what was not measured is told")
{
    BenchPoint failed = kBefore;
    failed.failure = "no memory";
    CHECK(compared(failed).failed.at(0) == "a samples=16, room, 960x540: no memory");
    CHECK(compareBenches({failed}, {kBefore}).failed.empty());
    const BenchComparison other = compared(benchPoint("b", 16, 2, 0.1));
    CHECK(other.compared == 0);
    CHECK(other.not_measured.size() == 1);
    BenchPoint wide = kBefore;
    wide.radius = 2;
    CHECK(compared(wide).not_measured.size() == 1);
}
