// SPDX-License-Identifier: MIT
// The choice of a config: by its worst scene, among those that were measured everywhere.
// What is measured next, and how sure an answer is, of made-up figures; and a config's neighbours.
#include "tools/measure/bench/choice.h"

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tests/tools/measure/bench/fixture.h"
#include "tools/measure/bench/quick.h"
#include "tools/measure/taps.h"

#include <crevice/shipped.h>

#include <tuple>

using namespace crevice;

namespace {

using Kind = ChoiceLimit::Kind;

std::vector<BenchSample> twoScenes()
{
    return {benchSample("fast", 4, 1, 0.10),   benchSample("fast", 4, 1.2, 0.08, "hall"),
            benchSample("middle", 8, 2, 0.05), benchSample("middle", 8, 2, 0.09, "hall"),
            benchSample("good", 16, 3, 0.06),  benchSample("good", 16, 5, 0.06, "hall"),
            benchSample("best", 32, 6, 0.03),  benchSample("best", 32, 6, 0.058, "hall")};
}

std::string chosen(const std::vector<BenchSample>& samples, Kind kind, double most,
                   const ChoiceScope& scope = {})
{
    const auto candidates = findCandidates(samples, scope);
    REQUIRE(candidates.ok());
    const auto choice = choose(*candidates, {{kind, most}});
    REQUIRE(choice.ok());
    return candidates->list[choice->within.front()].label;
}

Code refusal(const std::vector<BenchSample>& samples, const ChoiceScope& scope)
{
    const auto candidates = findCandidates(samples, scope);
    REQUIRE(!candidates.ok());
    return candidates.diagnostics().front().code;
}

Standing measured(double ms, double error)
{
    return {rangeOf(ms, 0.03 * ms), rangeOf(ms, 0.03 * ms), rangeOf(error, 0.03 * error), true};
}

/// By a small picture: a third to three times that.
Standing guessed(double ms, double error)
{
    const auto range = [](double value) { return scaled({value, value, value}, factorOf({})); };
    return {range(ms), range(ms), range(error)};
}

struct Row {
    std::vector<Standing> standings;
    ChoiceLimits limits;
    int next;  ///< -1: none.
    bool whole_front = false;
};

const Row kRows[] = {
    {{guessed(1, .1), guessed(2, .05)}, {{Kind::time_ms, 3}}, 1},   // the most promising first
    {{guessed(1, .1), guessed(20, .05)}, {{Kind::time_ms, 3}}, 0},  // too slow whatever it be
    {{guessed(20, .05)}, {{Kind::time_ms, 3}}, -1},
    {{measured(2, .05), guessed(2, .1)}, {{Kind::time_ms, 3}}, 1},  // may be at .033
    {{measured(2, .05), guessed(2, .16)}, {{Kind::time_ms, 3}}, -1},
    {{measured(4, .01), guessed(2, .16)}, {{Kind::time_ms, 3}}, 1},  // who is beyond leads nothing
    {{measured(2, .05), guessed(5, .1)}, {{Kind::error, .06}}, 1},   // may take 1.7
    {{measured(2, .05), guessed(7, .1)}, {{Kind::error, .06}}, -1},
    {{measured(2, .05), guessed(1, .2)}, {{Kind::error, .06}}, -1},
    {{measured(2, .05), guessed(1, .1)}, {{Kind::error, .06}, {Kind::ratio, .3}}, -1},
    {{guessed(1, .1)}, {{Kind::error, .06}, {Kind::ratio, .5}}, 0},
    {{measured(2, .05), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, -1},
    {{measured(2, .05), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, 1, true},  // .033 at 9 ms
    {{measured(2, .03), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, -1, true},
    {{}, {{Kind::time_ms, 2.5}}, -1, true},
};

/// Of that rmse at a hundred pixels, all alike; or one that is `more` wrong at every second one.
SparseError errorOf(double rmse, double more = 0)
{
    SparseError error;
    error.rmse = rmse;
    for (int i = 0; i < 100; ++i)
        error.squares.push_back(static_cast<float>(rmse * rmse + (i % 2 ? more : -more)));
    return error;
}

}  // namespace

TEST_CASE("the worst scene decides what a config costs and how wrong it is, or the one asked for")
{
    const struct {
        Kind kind;
        double most;
        const char* scene;
        const char* best;
    } rows[] = {{Kind::time_ms, 4, "", "middle samples=8"},
                {Kind::time_ms, 5, "", "good samples=16"},
                {Kind::time_ms, 6, "", "good samples=16"},  // as good, and faster
                {Kind::time_ms, 1.2, "", "fast samples=4"},
                {Kind::ratio, 20, "", "middle samples=8"},
                {Kind::error, 0.09, "", "middle samples=8"},
                {Kind::error, 0.06, "", "good samples=16"},
                {Kind::time_ms, 4, "room", "middle samples=8"},
                {Kind::error, 0.05, "room", "middle samples=8"}};
    for (const auto& [kind, most, scene, best] : rows)
        CHECK(chosen(twoScenes(), kind, most, {"", scene, {}}) == best);
    const auto candidates = findCandidates(twoScenes(), {});
    CHECK(candidates->list[2].slowest_view == "hall");
    CHECK(candidates->list[2].ratio_view == "hall");
    CHECK(candidates->list[1].worst_view == "hall");
}

TEST_CASE("everything within and beyond a limit is reported, the nearest first")
{
    const auto candidates = findCandidates(twoScenes(), {});
    const auto choice = choose(*candidates, {{Kind::error, 0.09}});
    REQUIRE(choice.ok());
    CHECK(choice->within == std::vector<std::size_t>{1, 2, 3});
    CHECK(choice->beyond == std::vector<std::size_t>{0});
    const auto none = choose(*candidates, {{Kind::time_ms, 0.5}});
    REQUIRE(!none.ok());
    CHECK(none.diagnostics().front().code == Code::out_of_range);
    CHECK(none.diagnostics().front().help.find("fast samples=4") != std::string::npos);
}

TEST_CASE("a config that lacks a scene, and a scene that has no other, are left out and said so")
{
    auto samples = twoScenes();
    samples.push_back(benchSample("wonder", 4, 0.1, 0.001));
    BenchSample failed = benchSample("wonder", 4, 0, 0, "hall");
    failed.failure = "no memory";
    samples.push_back(failed);
    CHECK(chosen(samples, Kind::time_ms, 100) == "good samples=16");
    const auto candidates = findCandidates(samples, {});
    REQUIRE(candidates->elided.size() == 1);
    CHECK(candidates->elided[0] == "wonder samples=4: no figures for hall");
    samples = twoScenes();
    samples.push_back(benchSample("wonder", 4, 0.1, 0.001, "street"));
    CHECK(chosen(samples, Kind::time_ms, 4) == "middle samples=8");
    CHECK(findCandidates(samples, {})->elided.at(0).find("scene street: ") == 0);
}

TEST_CASE("what is no better than no ambient occlusion in one scene is no candidate")
{
    auto samples = twoScenes();
    samples[1].error_without_ao = samples[1].error.rmse;  // fast, in the hall
    samples[2].error_without_ao = 0.4;
    const auto candidates = findCandidates(samples, {});
    REQUIRE(candidates.ok());
    CHECK(candidates->list.size() == 3);
    CHECK(candidates->harmful == std::vector<std::string>{"fast samples=4"});
    CHECK(candidates->elided.empty());
    CHECK(candidates->error_without_ao == 0.4);
    CHECK(!choose(*candidates, {{Kind::time_ms, 1.5}}).ok());
    for (BenchSample& sample : samples) sample.ratio_learnopengl = 0;  // there was none to compare
    CHECK(!choose(*findCandidates(samples, {}), {{Kind::ratio, 1000}}).ok());
}

TEST_CASE("sweeps of size and radius stay out of a choice, and a size can be asked for")
{
    auto samples = twoScenes();
    BenchSample small = benchSample("fast", 4, 0.01, 0.001);
    small.extent = {96, 54};
    BenchSample narrow = benchSample("good", 16, 0.01, 0.001);
    narrow.radius = 0.1;
    samples.push_back(small);
    samples.push_back(narrow);
    CHECK(chosen(samples, Kind::time_ms, 4) == "middle samples=8");
    CHECK(findCandidates(samples, {})->elided.empty());
    ChoiceScope scope;
    scope.extent = {96, 54};
    CHECK(chosen(samples, Kind::time_ms, 4, scope) == "fast samples=4");
}

TEST_CASE("scenes have radii of their own, and a config with another one than the rest is left out")
{
    auto samples = twoScenes();
    for (BenchSample& sample : samples) {
        if (sample.scene != "hall") continue;
        sample.radius = 50;
        sample.overrides[0] = "radius=50";
    }
    samples.push_back(benchSample("wide", 4, 0.1, 0.001));
    samples.back().radius = 1.5;
    CHECK(chosen(samples, Kind::time_ms, 4) == "middle samples=8");
    const auto candidates = findCandidates(samples, {});
    CHECK(candidates->list.size() == 4);
    REQUIRE(candidates->elided.size() == 1);
    CHECK(candidates->elided[0] == "wide samples=4: measured at 960x540 and radius 1.5 alone");
}

TEST_CASE("a front is what nothing beats, each figure once, and its knee is the balanced one")
{
    const auto listOf = [](const std::vector<std::pair<double, double>>& points) {
        std::vector<Candidate> list(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            std::tie(list[i].ms, list[i].error) = points[i];
        return list;
    };
    const auto knee = listOf({{16, 2}, {2, 3}, {4, 2.5}, {1, 10}, {2, 3}, {2, 4}, {3, 3}, {0, 0}});
    const std::vector<std::size_t> front = {3, 1, 2, 0};
    CHECK(frontOf(knee) == front);
    CHECK(balancedOf(knee, front) == 1);
    CHECK(balancedOf(listOf({{1, 1}}), {0}) == 0);
    CHECK(balancedOf(listOf({{10, 2}, {11, 1}}), {0, 1}) == 1);
    CHECK(balancedOf(listOf({{10, 2}, {30, 1}}), {0, 1}) == 0);
}

TEST_CASE("a choice refuses what the results do not hold")
{
    auto samples = twoScenes();
    for (const ChoiceScope& scope :
         {ChoiceScope{"", "cellar", {}}, {"", "", {1, 1}}, {"B", "", {}}})
        CHECK(refusal(samples, scope) == Code::usage);
    CHECK(refusal({}, {}) == Code::results_broken);
    samples.push_back(benchSample("fast", 4, 1, 0.1));
    samples.back().device = "device B";
    CHECK(refusal(samples, {}) == Code::usage);
    CHECK(findCandidates(samples, {"B", "", {}}).ok());
}

TEST_CASE("a file's view has its name, and its path where two are called so")
{
    std::vector<BenchSample> samples;
    for (const char* scene : {"room", "far/away/hall.glb", "a/tree.glb", "b/tree.glb"})
        samples.push_back(benchSample("fast", 4, 1, 0.1, scene));
    std::vector<std::string> names;
    for (const ResultView& view : benchViews(samples)) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"a/tree.glb", "b/tree.glb", "hall.glb", "room"});
}

TEST_CASE("a budget has a unit")
{
    CHECK(parseBudget("2ms")->most == 2);
    CHECK(parseBudget("2ms")->kind == Kind::time_ms);
    CHECK(parseBudget("500us")->most == 0.5);
    CHECK(parseBudget("2s")->most == 2000);
    CHECK(parseBudget("3.5x")->kind == Kind::ratio);
    for (const char* text : {"", "2", "ms", "0ms", "-1ms", "2 s", "2msx", "infms", "nan"})
        CHECK(!parseBudget(text).ok());
}

TEST_CASE("what could win even at the best of its ranges is measured, the most promising first")
{
    for (const Row& row : kRows) {
        INFO(&row - kRows);
        const auto next = nextOf(row.standings, row.limits, row.whole_front);
        CHECK((next ? static_cast<int>(*next) : -1) == row.next);
    }
    const std::vector<Standing> two = {measured(2, .05), measured(3, .04)};
    CHECK(leaderOf(two, {{Kind::time_ms, 4}}) == std::size_t(1));
    CHECK(leaderOf({measured(2, .042), two[1]}, {{Kind::time_ms, 4}}) == std::size_t(0));
    CHECK(leaderOf(two, {{Kind::time_ms, 4}, {Kind::error, .06}}) == std::size_t(0));
    CHECK(!leaderOf(two, {{Kind::time_ms, 4}, {Kind::error, .01}}));
    CHECK(nearestOf(two, {{Kind::time_ms, 1}, {Kind::error, .01}}) == 1);
    CHECK(nearestOf(two, {{Kind::time_ms, .1}, {Kind::error, .01}}) == 0);
}

TEST_CASE("ranges narrow with what small pictures turned out to be")
{
    CHECK(factorOf({}).low < 0.5);
    const Range known = factorOf({0.8, 1.0, 1.1});
    CHECK(known.value == 1.0);
    CHECK(known.low > 0.5);
    CHECK(known.low < 0.8);
    CHECK(known.high > 1.1);
    CHECK(known.high < 2.0);
}

TEST_CASE("an answer is sure where nothing else within the limits is better by over 5 %")
{
    const ChoiceLimits time = {{Kind::time_ms, 3}}, error = {{Kind::error, .06}};
    const SparseError best = errorOf(.040, .0001), near = errorOf(.0385, .0001),
                      far = errorOf(.03, .0001);
    std::vector<Standing> all = {measured(2, .04), measured(2.1, .0385)};
    all[0].pixels = &best;
    all[1].pixels = &near;
    CHECK(sureness(all, 0, time) > 0.9);  // as good: 4 % less wrong
    all[1] = measured(2.1, .03);
    all[1].pixels = &far;
    CHECK(sureness(all, 0, time) < 0.1);
    CHECK(sureness(all, 1, time) > 0.9);
    all[1].ms = rangeOf(4, .1);  // beyond the limit
    CHECK(sureness(all, 0, time) > 0.9);
    all[0].ms = rangeOf(3, .1);  // is it within?
    CHECK(sureness(all, 0, time) == Approx(0.5).margin(0.01));
    CHECK(sureness({measured(2, .05), measured(1.96, .05)}, 0, error) > 0.9);
    CHECK(sureness({measured(2, .05), measured(1.5, .05)}, 0, error) < 0.1);
}

TEST_CASE("neighbours move what costs time, and the rest of the settings stay")
{
    const Node document = need(loadConfig(shippedSources(), {"high"}));
    const auto settings = neighbourSettings(need(decode(document, shippedSources())));
    for (const char* setting : {"steps=18", "steps=8", "slices=3", "slices=1", "ao_scale=0.42",
                                "ao_scale=0.27", "guard_band=1.1", "back_faces=false"})
        CHECK(contains(settings, setting));
    for (const std::string& setting : settings) {
        INFO(setting);
        CHECK(!startsWith(setting, "radius="));
        CHECK(!startsWith(setting, "max_gap="));
        CHECK(loadConfig(shippedSources(), {"high", {}, {setting}}).ok());
    }
    CHECK(withSetting({"steps=2", "radius=1"}, "steps=3") ==
          std::vector<std::string>{"radius=1", "steps=3"});
    const auto swaps = filterSwaps(shippedSources(), {"hemisphere_box"});
    CHECK(contains(swaps, "filter/box=filter/median"));
    CHECK(filterSwaps(shippedSources(), {"mobile"}).empty());
}
