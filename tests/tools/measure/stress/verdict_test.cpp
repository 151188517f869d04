// SPDX-License-Identifier: MIT
// What the figures of stress cases mean, where a series breaks, and that lost occlusion is found.
#include "tests/tools/measure/stress/made_records.h"
#include "tools/measure/stress/differences.h"
#include "tools/measure/stress/passes.h"

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

TEST_CASE("A case that holds everywhere reaches its ends")
{
    Series series{caseOf(Expectation::open)};
    CHECK(series.found().failures == 0);
    CHECK(series.text() == "holds from a to e");
}

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

TEST_CASE("A series whose ordinary step fails holds nowhere and breaks there, once")
{
    Series series{caseOf(Expectation::same)};
    series.records[2].out_of_range = 3;
    const Breakdown found = series.found();
    CHECK(found.down.holds_to == -1);
    CHECK(found.up.breaks_at == 2);
    CHECK(series.text() == "breaks at c: 3 pixels out of range, 1 to 1");
    series.records[2].bad_pass = "ssao";
    series.records[2].bad_target = "ao";
    series.records[2].bad_x = 4;
    series.records[2].bad_y = 2;
    series.records[2].bad_value = 1.7;
    CHECK(series.text() ==
          "breaks at c: pass 'ssao' writes 3 pixels out of range into 'ao', the first at (4, 2): "
          "1.7");
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
          "holds from a to d; beyond depth24: 40 % of the occlusion lost, mean change 0.0045 at e");
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

TEST_CASE("What must settle fails where the next frame changes more than one pixel in a thousand")
{
    Series series{caseOf(Expectation::settles)};
    series.stress.limit = kRestlessShare;
    series.records[4].change = 0.0009;
    CHECK(series.found().failures == 0);
    series.records[4].change = 0.03;
    CHECK(series.text() ==
          "holds from a to d; breaks at e: the next frame changes 3 % of the pixels");
}

TEST_CASE("A failure names the pass that it begins with")
{
    Series series{caseOf(Expectation::same)};
    series.records[4].departing_pass = "ssao";
    CHECK(series.text() == "holds from a to e");
    series.records[4].change = 0.1;
    CHECK(series.text() == "holds from a to d; breaks at e: mean change 0.1, first in pass 'ssao'");
}

TEST_CASE("The pass that a failure begins with is the first that departs half as far")
{
    const auto passOf = [](float estimator, float filter) {
        const auto picture = [](float value) { return Image({2, 2}, 1, value); };
        const StressCase stress = caseOf(Expectation::same);
        const std::vector<PassPicture> ordinary = {{"ssao", "ao", picture(0.9f)},
                                                   {"filter", "ao_filtered", picture(0.9f)}};
        const std::vector<PassPicture> passes = {{"ssao", "ao", picture(estimator)},
                                                 {"filter", "ao_filtered", picture(filter)}};
        StressRecord record = occluded((1.0 - filter) / 0.1);
        record.step = 4;
        record.change = std::abs(filter - 0.9);
        return departingPass(stress, {}, passes, ordinary, record);
    };
    CHECK(passOf(0.9f, 0.9f).empty());
    CHECK(passOf(0.85f, 0.85f) == "ssao");
    CHECK(passOf(0.9f, 0.85f) == "filter");
    CHECK(passOf(0.897f, 0.85f) == "filter");
    CHECK(passOf(0.99f, 0.99f) == "ssao");
}

TEST_CASE("What a format cannot resolve must be sound, and is a figure and no tick")
{
    Series series{caseOf(Expectation::open)};
    series.records[4].resolved = 0;
    series.records[4].mean = 0.93;
    series.records[4].stored = "depth16";
    CHECK(series.outcome(4) == Outcome::beyond);
    CHECK(series.text() == "holds from a to d; beyond depth16: 7 % false occlusion at e");
    series.records[3] = series.records[4];
    series.records[3].mean = 1;
    CHECK(series.text() ==
          "holds from a to c; beyond depth16: 0 % false occlusion at d, 7 % false occlusion at e");
    series.records[3].mean = 0.93;
    CHECK(series.text() == "holds from a to c; beyond depth16: 7 % false occlusion from d to e");
    series.records[4].bad_pixels = 1;
    series.records[4].bad_pass = "ssao";
    series.records[4].bad_target = "ao";
    CHECK(series.outcome(4) == Outcome::breaks);
    CHECK(series.found().up.why.find("pass 'ssao' writes 1 pixels that are not finite") == 0);
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

TEST_CASE("What fails in a void case is told as well, and nothing of it holds")
{
    Series series{caseOf(Expectation::same), std::vector<StressRecord>(5, occluded(0.1))};
    series.records[3].change = 0.05;
    series.records[4].bad_pixels = 1;
    CHECK(series.outcome(0) == Outcome::invalid);
    CHECK(series.outcome(3) == Outcome::breaks);
    CHECK(series.found().failures == 3);
    CHECK(series.text() ==
          "VOID: the ordinary picture has 10 % of the ground truth's occlusion; "
          "breaks at d: mean change 0.05");
}

TEST_CASE("A refusal is no failure, and neither is what a config lacks")
{
    Series series{caseOf(Expectation::one)};
    series.records[0].refusal = "CV6011: the camera's clip_from_view has no inverse";
    series.records[4].absent = "no param 'samples'";
    CHECK(series.outcome(0) == Outcome::refused);
    CHECK(series.outcome(4) == Outcome::absent);
    CHECK(series.found().failures == 0);
    CHECK(series.text() == "holds from b to d; 1 refused");
}

TEST_CASE("A no-op must be exact and a change within the limit")
{
    Series one{caseOf(Expectation::one)};
    one.records[1].least = 0.9999;
    CHECK(one.outcome(1) == Outcome::breaks);
    Series same{caseOf(Expectation::same)};
    same.records[1].change = 0.0019;
    CHECK(same.outcome(1) == Outcome::holds);
    same.records[1].change = 0.0021;
    CHECK(same.outcome(1) == Outcome::breaks);
}

TEST_CASE("Smaller radii may not darken, and the smallest leaves all open")
{
    Series series{caseOf(Expectation::opens)};
    series.stress.ordinary = 4;
    for (int i = 0; i < 5; ++i) series.records[i].mean = 1 - 0.05 * i;
    CHECK(series.found().failures == 0);
    series.records[2].mean = 0.8;
    CHECK(series.outcome(2) == Outcome::breaks);
    series.records[0].mean = 0.99;
    CHECK(series.outcome(0) == Outcome::breaks);
}

TEST_CASE("Larger radii may not lighten a corner")
{
    Series series{caseOf(Expectation::darkens)};
    series.stress.ordinary = 0;
    for (int i = 0; i < 5; ++i) series.records[i].mean = 1 - 0.05 * i;
    CHECK(series.found().failures == 0);
    series.records[3].mean = 0.95;
    CHECK(series.found().up.breaks_at == 3);
}

TEST_CASE("A run differs from the one before where an outcome or a figure is another")
{
    const StressCase stress = caseOf(Expectation::same);
    std::vector<StressRecord> old(5, occluded(1)), edited(5, occluded(1));
    const auto seriesOver = [&stress](const std::vector<StressRecord>& records) {
        StressSeries series{&stress, "mine", "", {}};
        for (const StressRecord& record : records) series.steps.push_back(&record);
        return std::vector<StressSeries>{series};
    };
    std::size_t missing = 0;
    const auto found = [&] {
        std::string text;
        for (const StressDifference& each :
             differencesSince(seriesOver(old), seriesOver(edited), missing))
            text += each.step + ": " + each.what + "; ";
        return text;
    };
    CHECK(found().empty());
    edited[1].rmse += 0.0019;
    CHECK(found().empty());
    edited[1].rmse += 0.0002;
    CHECK(found() == "mine, made_up, b: rmse 0.0021, was 0; ");
    edited[1] = old[1];
    old[3].change = edited[3].change = 0.003;  // a failure that hides nothing
    CHECK(found().empty());
    edited[3].change = 0.006;
    edited[3].departing_pass = "filter_x";
    CHECK(found() == "mine, made_up, d: change 0.006, was 0.003, first in pass 'filter_x'; ");
    edited[3] = old[3];
    edited[4].change = 0.0025;
    CHECK(found() == "mine, made_up, e: breaks: mean change 0.0025; ");
    CHECK(missing == 0);
    CHECK(differencesSince({}, seriesOver(edited), missing).empty());
    CHECK(missing == 5);
}
