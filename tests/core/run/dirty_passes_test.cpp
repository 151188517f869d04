// SPDX-License-Identifier: MIT
// What a frame runs again: by the plan alone, without a device.
#include "core/run/dirty_passes.h"
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

struct Cached {
    explicit Cached(const Sketch& sketch, int views = 1)
        : plan(planOf(describe(sketch), traitsFor(views))),
          cache(plan)
    {
    }

    static SceneTraits traitsFor(int views)
    {
        SceneTraits traits;
        traits.views = views;
        return traits;
    }

    /// The passes that run where those named have changed, of further views with their number.
    std::string run(const std::vector<std::string>& changed)
    {
        std::vector<char> flags;
        std::vector<std::string> names;
        for (int view = 0; view < plan.views; ++view)
            for (const PlanPass& pass : plan.passes) {
                names.push_back(pass.name + (view > 0 ? std::to_string(view) : ""));
                flags.push_back(std::count(changed.begin(), changed.end(), names.back()) > 0);
            }
        const std::vector<char>& runs = cache.choose(flags);
        std::vector<std::string> chosen;
        for (std::size_t i = 0; i < runs.size(); ++i)
            if (runs[i]) chosen.push_back(names[i]);
        return joined(chosen);
    }

    Plan plan;
    PassCache cache;
};

/// Of a target that shares its texture with none of format r8.
const char* const kOwn = R"({"format": ["rgba8"]})";

/// The third pass draws into the first one's texture.
const Sketch kChain = {{"a: -> x", "b: x -> y", "c: y -> z", "d: z -> w"}, {{"out", "w"}}};

}  // namespace

TEST_CASE("The first frame runs every pass and one like it none")
{
    Cached cached(kChain);
    CHECK(cached.run({}) == "a, b, c, d");
    CHECK(cached.run({}).empty());
}

TEST_CASE("What has changed runs, and all that reads it")
{
    Cached cached({{"a: -> x", "b: x -> y", "side: -> s", "last: s y -> z"},
                   {{"out", "z"}},
                   {{"s", kOwn}, {"z", R"({"format": ["rg8"]})"}}});
    cached.run({});
    CHECK(cached.run({"last"}) == "last");
    CHECK(cached.run({"side"}) == "side, last");
    CHECK(cached.run({"a"}) == "a, b, last");
}

TEST_CASE("What another pass has overwritten is drawn again for whoever reads it")
{
    Cached cached(kChain);
    REQUIRE(cached.plan.targets[0].texture == cached.plan.targets[2].texture);
    cached.run({});
    CHECK(cached.run({"b"}) == "a, b, c, d");
    CHECK(cached.run({"d"}) == "d");
}

TEST_CASE("A pass and what draws over it run both or neither")
{
    Cached cached({{"a: -> x", "b: x -> y", R"(c: s -> y | "over": "b")", "side: -> s", "d: y -> z",
                    "e: z -> v"},
                   {{"out", "v"}},
                   {{"s", kOwn}}});
    cached.run({});
    CHECK(cached.run({"side"}) == "a, b, side, c, d, e");
    CHECK(cached.run({"b"}) == "a, b, c, d, e");
    CHECK(cached.run({"e"}) == "e");
    CHECK(cached.run({"d"}) == "a, b, c, d, e");  // "e" has overwritten what they drew
}

TEST_CASE("After a frame that failed everything runs")
{
    Cached cached(kChain);
    cached.run({});
    cached.cache.clear();
    CHECK(cached.run({}) == "a, b, c, d");
}

TEST_CASE("What remembers runs in every frame")
{
    Cached cached({{"a: -> now", "mean: now mean_history -> mean", "show: mean -> color"},
                   {{"out", "color"}},
                   {{"mean", R"({"format": ["r8"], "history": true})"}, {"color", kOwn}}});
    cached.run({});
    CHECK(cached.run({}) == "mean, show");
}

TEST_CASE("Views that share a texture draw into it in turn")
{
    Cached cached({{"a: -> x", "b: x -> y"}, {{"out", "y"}}}, 2);
    CHECK(cached.run({}) == "a, b, a1, b1");
    CHECK(cached.run({}).empty());
    CHECK(cached.run({"b1"}) == "b1");
    CHECK(cached.run({"b"}) == "a, b");
    CHECK(cached.run({"b", "b1"}) == "b, a1, b1");
}
