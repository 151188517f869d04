// SPDX-License-Identifier: MIT
// The choice of a config: by its worst scene, among those that were measured everywhere.
#include "tools/measure/bench/choice.h"

#include "tests/support/catch.h"
#include "tests/tools/measure/bench/fixture.h"

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
