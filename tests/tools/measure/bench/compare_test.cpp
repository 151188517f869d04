// SPDX-License-Identifier: MIT
// The regression guard: errors count in both directions, ratios that grow, absolute times never.
#include "tools/measure/bench/compare.h"

#include "tests/support/catch.h"
#include "tests/tools/measure/bench/fixture.h"

using namespace crevice;

namespace {

BenchSample sampleBefore()
{
    BenchSample sample = benchSample("a", 16, 2, 0.1);
    sample.motion.paths["pan"].rms = 0.02;
    sample.motion.paths["pan"].rmse = 0.05;
    return sample;
}

const BenchSample kBefore = sampleBefore();

/// "worse rmse, odd bias, better ratio_copy, no ratios": what a comparison says, an error that is
/// better being odd.
std::string told(const BenchComparison& comparison)
{
    std::string text;
    const auto say = [&text](const std::string& what) {
        text += (text.empty() ? "" : ", ") + what;
    };
    for (const BenchChange& each : comparison.worse) say("worse " + each.figure);
    for (const BenchChange& each : comparison.better_errors) say("odd " + each.figure);
    for (const BenchChange& each : comparison.better) say("better " + each.figure);
    for (const std::string& each : comparison.failed) say("fails " + each);
    for (const std::string& each : comparison.missing) say("missing " + each);
    if (comparison.without_ratios > 0) say("no ratios");
    const bool fine = comparison.worse.empty() && comparison.better_errors.empty() &&
                      comparison.failed.empty() && comparison.missing.empty();
    CHECK(comparison.differs() == !fine);
    return text;
}

BenchComparison compared(const BenchSample& now, const BenchLimits& limits = {})
{
    return compareBenches({kBefore}, {now}, limits);
}

struct Row {
    void (*edit)(BenchSample& now);
    const char* told;
    BenchLimits limits = {};
};

const BenchLimits kLooseErrors = {0.001, 1e-4, 0.15, false},
                  kLooseRatios = {1e-6, 1e-4, 0.2, false}, kErrorsOnly = {1e-6, 1e-4, 0.15, true};

const Row kRows[] = {
    {[](BenchSample& now) {  // times and keys alone
         now.total.median *= 10;
         now.cost.median *= 10;
         now.key = "of an edited shader";
         now.version = "1.1";
     },
     ""},
    {[](BenchSample& now) { now.error.rmse += 0.9e-6; }, ""},
    {[](BenchSample& now) { now.error.rmse -= 0.9e-6; }, ""},
    {[](BenchSample& now) { now.error.rmse += 0.0002; }, "worse rmse"},
    {[](BenchSample& now) { now.error.rmse -= 0.0002; }, "odd rmse"},
    {[](BenchSample& now) { now.error.rmse += 0.0002; }, "", kLooseErrors},
    {[](BenchSample& now) { now.error.rmse -= 0.0002; }, "", kLooseErrors},
    {[](BenchSample& now) { now.error.rmse_fit += 0.0002; }, "worse rmse_fit"},
    {[](BenchSample& now) { now.error.rmse_fit -= 0.0002; }, "odd rmse_fit"},
    {[](BenchSample& now) { now.error.bias += 0.0002; }, "odd bias"},
    {[](BenchSample& now) { now.error.bias -= 0.0002; }, "worse bias"},
    {[](BenchSample& now) { now.error.bias = -now.error.bias + 0.01; }, "worse bias"},
    {[](BenchSample& now) { now.error.bias = -now.error.bias - 0.01; }, "odd bias"},
    {[](BenchSample& now) {  // across versions
         now.error.rmse += 0.9e-4;
         now.version = "1.1";
     },
     ""},
    {[](BenchSample& now) {
         now.error.rmse += 0.9e-4;
         now.device = "device B";
         now.ratio_copy *= 5;
     },
     "no ratios"},
    {[](BenchSample& now) {
         now.error.rmse += 1.1e-4;
         now.device = "device B";
     },
     "worse rmse, no ratios"},
    {[](BenchSample& now) {
         now.error.rmse += 0.1;
         now.clock = "cpu";
         now.ratio_copy *= 5;
     },
     "worse rmse, no ratios"},
    {[](BenchSample& now) { now.ratio_copy *= 1.14; }, ""},
    {[](BenchSample& now) {
         now.ratio_copy *= 1.16;
         now.ratio_learnopengl /= 1.16;
     },
     "worse ratio_copy, better ratio_learnopengl"},
    {[](BenchSample& now) { now.ratio_copy *= 1.16; }, "", kLooseRatios},
    {[](BenchSample& now) { now.ratio_copy *= 1.16; }, "", kErrorsOnly},
    {[](BenchSample& now) { now.ratio_copy /= 2; }, "better ratio_copy"},
    {[](BenchSample& now) { now.ratio_copy = 0; }, ""},
    {[](BenchSample& now) { now.motion = {}; }, ""},
    {[](BenchSample& now) { now.motion.paths["strafe"].rms = 0.5; }, ""},
    {[](BenchSample& now) {
         now.motion.paths["pan"].rms = 0.021;
         now.motion.paths["pan"].rmse = 0.049;
     },
     "worse motion pan, odd motion pan rmse"},
    {[](BenchSample& now) { now.disable = {"no_op"}; }, ""},  // which may change no pixel
    {[](BenchSample& now) { now.failure = "no memory"; },
     "fails a samples=16, room, 960x540: no memory"},
    {[](BenchSample& now) { now.config = "b"; }, "missing a samples=16, room, 960x540"},
    {[](BenchSample& now) { now.radius = 2; }, "missing a samples=16, room, 960x540"},
};

}  // namespace

TEST_CASE("a bench counts errors in both directions, ratios that grow, and no times")
{
    for (const Row& row : kRows) {
        BenchSample now = kBefore;
        row.edit(now);
        INFO("row " << &row - kRows);
        CHECK(told(compared(now, row.limits)) == row.told);
    }
}

TEST_CASE("a change has its sample, both figures and what would have been the same")
{
    BenchSample now = kBefore;
    now.error.rmse -= 0.0002;
    const BenchComparison comparison = compared(now);
    CHECK(comparison.compared == 1);
    const BenchChange& change = comparison.better_errors.at(0);
    CHECK(change.sample == "a samples=16, room, 960x540");
    CHECK(change.before == kBefore.error.rmse);
    CHECK(change.now == now.error.rmse);
    CHECK(change.limit == Approx(kBefore.error.rmse - 1e-6).margin(1e-9));
}

TEST_CASE("of samples of one question that from the same device is compared, then one as it was")
{
    BenchSample elsewhere = kBefore, bare = kBefore;
    elsewhere.device = "device B";
    bare.disable = {"no_op"};
    bare.error.rmse += 0.1;
    elsewhere.error.rmse += 0.1;
    CHECK(told(compareBenches({kBefore}, {bare, elsewhere, kBefore})).empty());
    CHECK(told(compareBenches({bare}, {kBefore, bare})).empty());
    CHECK(told(compareBenches({kBefore}, {elsewhere, bare})) == "worse rmse");
}

TEST_CASE("what failed before does not count, whatever it is now")
{
    BenchSample failed = kBefore;
    failed.failure = "no memory";
    CHECK(told(compareBenches({failed}, {kBefore})).empty());
    CHECK(told(compareBenches({failed}, {})).empty());
    CHECK(compared(benchSample("b", 16, 2, 0.1)).compared == 0);
}
