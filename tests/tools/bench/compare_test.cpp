// SPDX-License-Identifier: MIT
// The regression guard: errors count in both directions, ratios that grow, absolute times never.
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
    CHECK_FALSE(comparison.differs());
    CHECK(comparison.better.empty());
}

TEST_CASE("an error beyond the limit is worse or better, and neither is the same")
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
    CHECK_FALSE(compared(now, loose).differs());
    now.error.rmse = kBefore.error.rmse - 0.0002;
    CHECK(compared(now).worse.empty());
    REQUIRE(compared(now).better_errors.size() == 1);
    CHECK(compared(now).better_errors[0].limit == Approx(kBefore.error.rmse - 1e-6).margin(1e-9));
    CHECK(compared(now).differs());
    CHECK_FALSE(compared(now, loose).differs());
    now.error.rmse = kBefore.error.rmse - 0.9e-6;
    CHECK_FALSE(compared(now).differs());
}

TEST_CASE("each of the errors counts, in both directions")
{
    for (const double change : {-0.0002, 0.0002}) {
        BenchSample now = kBefore;
        now.error.rmse_fit += change;
        CHECK(compared(now).differs());
        now = kBefore;
        now.error.bias += change;
        CHECK(compared(now).differs());
    }
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

TEST_CASE("a bias that grows is worse in either direction, and one of the other sign is another")
{
    BenchSample now = kBefore;
    now.error.bias = -kBefore.error.bias + 0.01;
    REQUIRE(compared(now).worse.size() == 1);
    now.error.bias = kBefore.error.bias - 0.01;
    CHECK(compared(now).worse.size() == 1);
    BenchSample before = kBefore;
    before.error.bias = 0.01;
    now.error.bias = -0.01;
    CHECK(compareBenches({before}, {now}).worse.size() == 1);
    now.error.bias = -0.005;
    CHECK(compareBenches({before}, {now}).better_errors.size() == 1);
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
    BenchSample quicker = kBefore;
    quicker.ratio_copy /= 2;
    CHECK(compared(quicker).better.size() == 1);
    CHECK_FALSE(compared(quicker).differs());
    BenchLimits loose;
    loose.ratio = 0.2;
    CHECK(compared(now, loose).worse.empty());
    BenchLimits errors;
    errors.errors_only = true;
    CHECK(compared(now, errors).worse.empty());
    now.ratio_copy = 0;
    CHECK(compared(now).worse.empty());
}

TEST_CASE("motion is compared where both benches have it, along each path that both have")
{
    BenchSample before = kBefore, now = kBefore;
    before.motion.paths["pan"].rms = 0.02;
    before.motion.paths["pan"].rmse = 0.05;
    CHECK(!compareBenches({before}, {now}).differs());
    CHECK(!compareBenches({now}, {before}).differs());
    now.motion.paths["strafe"].rms = 0.5;
    CHECK(!compareBenches({before}, {now}).differs());
    now.motion.paths["pan"] = before.motion.paths["pan"];
    now.motion.paths["pan"].rms = 0.021;
    now.motion.paths["pan"].rmse = 0.049;
    const BenchComparison result = compareBenches({before}, {now});
    REQUIRE(result.worse.size() == 1);
    CHECK(result.worse[0].figure == "motion pan");
    CHECK(result.worse[0].now == 0.021);
    REQUIRE(result.better_errors.size() == 1);
    CHECK(result.better_errors[0].figure == "motion pan rmse");
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

TEST_CASE("ratios by another clock are not compared, and errors are")
{
    BenchSample now = kBefore;
    now.clock = "cpu";
    now.ratio_copy *= 5;
    now.error.rmse += 0.1;
    REQUIRE(compared(now).worse.size() == 1);
    CHECK(compared(now).worse[0].figure == "rmse");
    CHECK(compared(now).without_ratios == 1);
}

TEST_CASE("what fails or is missing now is worse, and what failed before does not count")
{
    BenchSample failed = kBefore;
    failed.failure = "no memory";
    CHECK(compared(failed).failed.at(0) == "a samples=16, room, 960x540: no memory");
    CHECK(compared(failed).differs());
    CHECK(!compareBenches({failed}, {kBefore}).differs());
    CHECK(!compareBenches({failed}, {}).differs());
    const BenchComparison other = compared(benchSample("b", 16, 2, 0.1));
    CHECK(other.compared == 0);
    CHECK(other.missing.size() == 1);
    CHECK(other.differs());
    BenchSample wide = kBefore;
    wide.radius = 2;
    CHECK(compared(wide).missing.size() == 1);
}
