// SPDX-License-Identifier: MIT
// The regression guard: errors and ratios count, absolute times do not.
#include "tools/bench/compare.h"

#include "tests/support/catch.h"
#include "tests/tools/bench/fixture.h"

using namespace crevice;

namespace {

const BenchSample kBefore = benchSample("a", 16, 2, 0.1);

BenchComparison compared(const BenchSample& now, const BenchLimits& limits = {})
{
    return compareBenches({kBefore}, {now}, limits);
}

}  // namespace

TEST_CASE("a bench is no worse than itself, nor where times alone are others")
{
    BenchSample now = kBefore;
    now.total.median *= 10;
    now.cost.median *= 10;
    now.key = "of an edited shader";
    now.version = "1.1";
    const BenchComparison comparison = compared(now);
    CHECK(comparison.compared == 1);
    CHECK(comparison.worse.empty());
    CHECK(comparison.better.empty());
}

TEST_CASE("more error than the limit is worse, less is better")
{
    BenchSample now = kBefore;
    now.error.rmse += 0.9e-6;
    CHECK(compared(now).worse.empty());
    now.error.rmse = kBefore.error.rmse + 0.0002;
    REQUIRE(compared(now).worse.size() == 1);
    CHECK(compared(now).worse[0].figure == "rmse");
    CHECK(compared(now).worse[0].sample == "a samples=16, room, 960x540");
    BenchLimits loose;
    loose.error = 0.001;
    CHECK(compared(now, loose).worse.empty());
    now.error.rmse = kBefore.error.rmse - 0.0002;
    CHECK(compared(now).worse.empty());
    CHECK(compared(now).better.size() == 1);
}

TEST_CASE("errors agree more closely on one device and version than across them")
{
    BenchSample now = kBefore;
    now.error.rmse += 0.9e-4;
    CHECK(compared(now).worse.size() == 1);
    now.version = "1.1";
    CHECK(compared(now).worse.empty());
    now.version = kBefore.version;
    now.device = "device B";
    CHECK(compared(now).worse.empty());
    now.error.rmse += 0.2e-4;
    CHECK(compared(now).worse.size() == 1);
}

TEST_CASE("a bias that grows is worse in either direction")
{
    BenchSample now = kBefore;
    now.error.bias = -kBefore.error.bias + 0.01;
    REQUIRE(compared(now).worse.size() == 1);
    now.error.bias = kBefore.error.bias - 0.01;
    CHECK(compared(now).worse.size() == 1);
}

TEST_CASE("a cost ratio is worse beyond its share")
{
    BenchSample now = kBefore;
    now.ratio_copy *= 1.14;
    CHECK(compared(now).worse.empty());
    now.ratio_copy = kBefore.ratio_copy * 1.16;
    now.ratio_learnopengl = kBefore.ratio_learnopengl / 1.16;
    REQUIRE(compared(now).worse.size() == 1);
    CHECK(compared(now).worse[0].figure == "ratio_copy");
    CHECK(compared(now).better.size() == 1);
    BenchLimits loose;
    loose.ratio = 0.2;
    CHECK(compared(now, loose).worse.empty());
    BenchLimits errors;
    errors.errors_only = true;
    CHECK(compared(now, errors).worse.empty());
    now.ratio_copy = 0;
    CHECK(compared(now).worse.empty());
}

TEST_CASE("on another device errors are compared and ratios are not")
{
    BenchSample now = kBefore;
    now.device = "device B";
    now.ratio_copy *= 5;
    CHECK(compared(now).worse.empty());
    CHECK(compared(now).without_ratios == 1);
    now.error.rmse += 0.1;
    CHECK(compared(now).worse.size() == 1);
    CHECK(compareBenches({kBefore}, {now, kBefore}).worse.empty());
}

TEST_CASE("what fails or is missing now is worse, and what failed before does not count")
{
    BenchSample failed = kBefore;
    failed.failure = "no memory";
    CHECK(compared(failed).failed.at(0) == "a samples=16, room, 960x540: no memory");
    CHECK(compared(failed).isWorse());
    CHECK(!compareBenches({failed}, {kBefore}).isWorse());
    CHECK(!compareBenches({failed}, {}).isWorse());
    const BenchComparison other = compared(benchSample("b", 16, 2, 0.1));
    CHECK(other.compared == 0);
    CHECK(other.missing.size() == 1);
    CHECK(other.isWorse());
    BenchSample wide = kBefore;
    wide.radius = 2;
    CHECK(compared(wide).missing.size() == 1);
}
