// SPDX-License-Identifier: MIT
// The regression guard: errors count in both directions, ratios that grow, absolute times never.
#include "tools/measure/bench/compare.h"

#include "core/base/text.h"
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

/// "worse rmse, odd bias, cheaper ratio_copy, no ratios": what a comparison says.
std::string told(const BenchComparison& comparison)
{
    const char* const words[] = {"cheaper", "odd", "worse", "fails", "missing"};
    std::vector<std::string> all;
    bool fine = true;
    for (const BenchChange& change : comparison.changes) {
        all.push_back(words[static_cast<int>(change.kind)] + (" " + change.figure));
        fine = fine && change.kind == BenchChange::Kind::cheaper;
    }
    CHECK(comparison.differs() == !fine);
    if (comparison.without_ratios > 0) all.push_back("no ratios");
    return joined(all);
}

struct Row {
    void (*edit)(BenchSample& now);
    const char* told;
    bool errors_only = false;
};

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
    {[](BenchSample& now) { now.error.rmse_fit += 0.0002; }, "worse rmse_fit"},
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
     "worse ratio_copy, cheaper ratio_learnopengl"},
    {[](BenchSample& now) { now.ratio_copy *= 1.16; }, "", true},
    {[](BenchSample& now) { now.ratio_copy /= 2; }, "cheaper ratio_copy"},
    {[](BenchSample& now) { now.ratio_copy = 0; }, ""},
    {[](BenchSample& now) { now.motion = {}; }, ""},
    {[](BenchSample& now) {
         now.motion.paths["pan"].rms = 0.021;
         now.motion.paths["pan"].rmse = 0.049;
     },
     "worse motion pan, odd motion pan rmse"},
    {[](BenchSample& now) { now.disable = {"no_op"}; }, ""},  // which may change no pixel
    {[](BenchSample& now) { now.failure = "no memory"; }, "fails no memory"},
    {[](BenchSample& now) { now.config = "b"; }, "missing "},
    {[](BenchSample& now) { now.radius = 2; }, "missing "},
};

}  // namespace

TEST_CASE("a bench counts errors in both directions, ratios that grow, and no times")
{
    for (const Row& row : kRows) {
        BenchSample now = kBefore;
        row.edit(now);
        INFO("row " << &row - kRows);
        CHECK(told(compareBenches({kBefore}, {now}, row.errors_only)) == row.told);
    }
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
}
