// SPDX-License-Identifier: MIT
// What the figures of stress cases mean, where a series breaks, and that lost occlusion is found.
#include "tests/tools/measure/stress/made_records.h"

#include "tests/support/catch.h"

#include <cmath>

using namespace crevice;

namespace {

/// Five steps, of which the third is ordinary.
StressCase caseOf(Expectation expectation)
{
    StressCase stress;
    stress.name = "made_up";
    stress.steps = {{0, "a"}, {1, "b"}, {2, "c"}, {3, "d"}, {4, "e"}};
    stress.ordinary = 2;
    stress.expectation = expectation;
    return stress;
}

/// A step whose exact answer has a tenth of occlusion, of which `strength` is drawn.
StressRecord occluded(double strength)
{
    StressRecord record = good();
    record.radius_px = 20;
    record.exact = 0.1;
    record.occlusion = 0.1 * strength;
    record.mean = record.least = 1 - record.occlusion;
    record.rmse_white = 0.2;
    record.rmse = 0.2 * std::abs(1 - strength);
    return record;
}

struct Series {
    StressCase stress;
    std::vector<StressRecord> records = std::vector<StressRecord>(5, good());

    std::vector<const StressRecord*> pointers() const
    {
        std::vector<const StressRecord*> all;
        for (const StressRecord& record : records) all.push_back(&record);
        return all;
    }
    Breakdown found() const { return findBreakdown(stress, pointers()); }
    Outcome outcome(std::size_t step) const { return judge(stress, pointers(), step).outcome; }
    std::string text() const { return describe(stress, found()); }
};

}  // namespace

TEST_CASE("The breakdown point is the first step that fails, walking away from the ordinary one")
{
    Series series{caseOf(Expectation::open)};
    series.records[0].judged_mean = 0.9;
    series.records[3].judged_below = 0.25;
    series.records[3].judged_least = 0.5;
    series.records[4].bad_pixels = 7;
    const Breakdown found = series.found();
    CHECK(found.down.holds_to == 1);
    CHECK(found.down.breaks_at == 0);
    CHECK(found.up.holds_to == 2);
    CHECK(found.up.breaks_at == 3);
    CHECK(found.failures == 3);
    CHECK(series.text() ==
          "holds from b to c; breaks at a: mean 0.9, least 1; breaks at d: mean 1, "
          "least 0.5, 25 % below 0.95");
}

TEST_CASE("Where steps are coarse a picture may change, and what changed is said")
{
    Series series{caseOf(Expectation::same)};
    StressRecord& far = series.records[4];
    far.change = 0.0045;
    far.step_share = 0.019;
    CHECK(series.outcome(4) == Outcome::breaks);
    far.step_share = 0.04;
    far.stored = "depth24";
    far.radius_px = 20;
    far.exact = 0.1;
    far.occlusion = 0.06;
    CHECK(series.outcome(4) == Outcome::beyond);
    CHECK(series.found().failures == 0);
    CHECK(series.text() ==
          "holds from a to d; beyond depth24 at e: 40 % of the occlusion lost, mean change 0.0045");
    far.occlusion = 0.04;
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why == "60 % of the occlusion lost, mean change 0.0045");
    // Steps of 0.04 of the radius change a picture by sin^2(0.16) = 0.0254 and half a step of 8
    // bits.
    far.occlusion = 0.1;
    far.change = 0.0273;
    CHECK(series.outcome(4) == Outcome::beyond);
    far.change = 0.0275;
    CHECK(series.outcome(4) == Outcome::breaks);
}

TEST_CASE(
    "Of every case but planes and no-ops, a white picture fails, and one of half the strength")
{
    const double strength = GENERATE(0.0, 0.14, 0.5);
    for (const StressCase& stress : stressCases()) {
        INFO(stress.name);
        const bool white =
            stress.expectation == Expectation::open || stress.expectation == Expectation::one;
        const StressRecord record = white ? good() : occluded(strength);
        const Series series{stress, std::vector<StressRecord>(stress.steps.size(), record)};
        const Breakdown found = series.found();
        CHECK((found.failures == 0) == white);
        if (white) continue;
        CHECK(found.up.holds_to == -1);
        CHECK(series.text().find("VOID: the ordinary picture has " +
                                 std::to_string(std::lround(strength * 100)) +
                                 " % of the ground truth's occlusion") == 0);
    }
}

TEST_CASE("An ordinary picture is valid by its strength, and closer to the truth than a grey one")
{
    Series series{caseOf(Expectation::same)};
    StressRecord& ordinary = series.records[2];
    const auto outcomeOf = [&](double strength) {
        ordinary = occluded(strength);
        return series.outcome(2);
    };
    CHECK(outcomeOf(0.66) == Outcome::invalid);
    CHECK(outcomeOf(0.67) == Outcome::holds);
    CHECK(outcomeOf(1.49) == Outcome::holds);
    CHECK(outcomeOf(1.51) == Outcome::invalid);
    ordinary = occluded(1);
    ordinary.rmse = 0.18;  // the truth deviates by the root of 0.2^2 - 0.1^2 from its mean
    CHECK(series.outcome(2) == Outcome::invalid);
    CHECK(series.text().find("VOID: the ordinary picture is no closer to the ground truth") == 0);
    ordinary.exact = 0.005;  // a plane
    CHECK(series.outcome(2) == Outcome::holds);
}

TEST_CASE("A step that lost more than half of the ground truth's occlusion fails")
{
    const auto expectation = GENERATE(Expectation::sound, Expectation::opens, Expectation::darkens);
    Series series{caseOf(expectation), std::vector<StressRecord>(5, occluded(0.9))};
    series.records[0].mean = 1;
    StressRecord& step = series.records[4];
    step.occlusion = 0.051;
    CHECK(series.outcome(4) == Outcome::holds);
    step.occlusion = 0.049;
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why == "49 % of the ground truth's occlusion");
    step.radius_px = 1.9;  // nothing of it is on the screen
    CHECK(series.outcome(4) == Outcome::holds);
}

TEST_CASE("What a format cannot resolve must be sound, and is a figure and no tick")
{
    Series series{caseOf(Expectation::open)};
    series.records[4].resolved = 0;
    series.records[4].mean = 0.93;
    series.records[4].stored = "depth16";
    CHECK(series.text() == "holds from a to d; beyond depth16 at e: 7 % false occlusion");
    series.records[4].bad_pixels = 1;
    CHECK(series.outcome(4) == Outcome::breaks);
}

TEST_CASE("A refusal is no failure, and neither is what a config lacks")
{
    Series series{caseOf(Expectation::one)};
    series.records[0].refusal = "CV6011: the camera's clip_from_view has no inverse";
    series.records[4].absent = "no param 'samples'";
    CHECK(series.found().failures == 0);
    CHECK(series.text() == "holds from b to d; 1 refused");
}

TEST_CASE("Each expectation fails just past its limit")
{
    Series one{caseOf(Expectation::one)};
    one.records[1].least = 0.9999;
    CHECK(one.outcome(1) == Outcome::breaks);

    Series same{caseOf(Expectation::same)};
    same.records[1].change = 0.0019;
    CHECK(same.outcome(1) == Outcome::holds);
    same.records[1].change = 0.0021;
    CHECK(same.outcome(1) == Outcome::breaks);

    Series settles{caseOf(Expectation::settles)};
    settles.stress.limit = kRestlessShare;
    settles.records[3].change = 0.0009;
    settles.records[4].change = 0.03;
    CHECK(settles.text() ==
          "holds from a to d; breaks at e: the next frame changes 3 % of the pixels");

    Series opens{caseOf(Expectation::opens)}, darkens{caseOf(Expectation::darkens)};
    opens.stress.ordinary = 4;
    darkens.stress.ordinary = 0;
    for (int i = 0; i < 5; ++i) opens.records[i].mean = darkens.records[i].mean = 1 - 0.05 * i;
    CHECK(opens.found().failures + darkens.found().failures == 0);
    opens.records[2].mean = 0.8;
    CHECK(opens.outcome(2) == Outcome::breaks);
    opens.records[0].mean = 0.99;
    CHECK(opens.outcome(0) == Outcome::breaks);
    darkens.records[3].mean = 0.95;
    CHECK(darkens.found().up.breaks_at == 3);
}
