// SPDX-License-Identifier: MIT
// Textures of a plan: sizes, formats, limits, load and store operations, shared slots.
#include "tests/support/plan_rig.h"

#include <random>

using namespace crevice;

namespace {

Sketch oneTarget(const std::string& json) { return {{"a: -> x"}, {{"out", "x"}}, {{"x", json}}}; }

}  // namespace

TEST_CASE("Sizes are rounded up and never vanish, and a border is whole pixels on either side")
{
    const auto size = [](const std::string& keys, int width, int height) {
        const std::string json = R"({"format": ["r8"], "size": {)" + keys + "}}";
        return planOf(describe(oneTarget(json)), {}, sized(width, height)).textures[0].extent;
    };
    CHECK(size(R"("scale": 0.5)", 101, 64) == Extent{51, 32});
    CHECK(size(R"("scale": 0.25)", 3, 1) == Extent{1, 1});
    CHECK(size(R"("scale": 2)", 101, 64) == Extent{202, 128});
    const auto bordered = [&](const std::string& scale, int width, int height) {
        return size(R"("border": true, "scale": )" + scale, width, height);
    };
    CHECK(bordered("1", 101, 64) == Extent{101, 64});
    CHECK(bordered("1.2", 640, 360) == Extent{768, 432});
    CHECK(bordered("1.4", 480, 270) == Extent{672, 378});
    CHECK(bordered("1.4", 256, 144) == Extent{360, 202});
    CHECK(bordered("1.2", 1366, 768) == Extent{1640, 922});
    CHECK(bordered("1.35", 333, 187) == Extent{451, 253});
    CHECK(bordered("2", 75, 64) == Extent{151, 128});
    CHECK(bordered("4", 1, 2) == Extent{5, 8});
}

TEST_CASE("A scale's own rounding adds no pixel")
{
    for (int hundredths = 5; hundredths <= 200; hundredths += 5) {
        const std::string scale = std::to_string(hundredths / 100.0);
        const std::string json = R"({"format": ["r8"], "size": {"scale": )" + scale + "}}";
        const Description description = describe(oneTarget(json));
        for (const int size : {7, 90, 100, 360, 480, 640, 768, 1000}) {
            INFO(scale << " of " << size);
            const int expected = (size * hundredths + 99) / 100;
            CHECK(planOf(description, {}, sized(size, size)).textures[0].extent ==
                  Extent{expected, expected});
        }
    }
}

TEST_CASE("The first format that the device renders to is taken, and a fall-back is a warning")
{
    const Description description =
        describe(oneTarget(R"({"format": ["rgba32f", "rgba16f", "rgb10_a2", "rgba8"]})"));
    const Result<Plan> plan = compile(description, {}, minimumCaps(), sized());
    CHECK(onlyWarning(plan, Code::no_format).pointer == "/targets/x");
    CHECK(plan->textures[0].format == Format::rgb10_a2);
    CHECK(compile(description, {}, ampleCaps(), sized()).diagnostics().empty());
}

TEST_CASE("A fullscreen pass loads nothing, and a draw and a test clear first")
{
    const auto load = [](const std::string& keys) {
        const Plan plan = planOf(describe(
            Sketch{{"a: -> x |" + keys}, {{"out", "x"}}, {{"d", R"({"format": ["depth24"]})"}}}));
        return *attachmentOf(plan, "x");
    };
    CHECK(load(R"("type": "fullscreen")").load == LoadOp::discard);
    CHECK(load(R"("type": "draw")").load == LoadOp::clear);
    CHECK(load(R"("depth": "d", "state": {"depth_test": "less"})").load == LoadOp::clear);
    CHECK(load(R"("type": "draw", "clear": {"x": [1, 2, 3, 4]})").clear ==
          std::array<float, 4>{1, 2, 3, 4});
    CHECK(load(R"("type": "draw")").clear == std::array<float, 4>{0, 0, 0, 0});
}

TEST_CASE("A shader that discards leaves pixels, so its target is cleared")
{
    const Description description =
        describe(R"({"format": 1, "targets": {"x": {"format": ["r8"]}},
        "shaders": {"s": {"vertex": "v", "fragment": "f"}},
        "passes": {"p": {"shader": "s", "color": "x"}}, "outputs": {"x": "x"}})",
                 {{"v", kFullVertex},
                  {"f", "#version 300 es\nout highp vec4 c;\nvoid main() { discard; }\n"}});
    CHECK(planOf(description).passes[0].color[0].load == LoadOp::clear);
}

TEST_CASE("Depth is cleared to 1, needs a texture even unread, and is stored where it is sampled")
{
    const auto drawn = [](const std::string& reads, const SceneTraits& traits = {}) {
        const Sketch sketch{{R"(g: -> x | "type": "draw", "depth": "d")", "h: " + reads + " -> y"},
                            {{"out", "y"}},
                            {{"d", R"({"format": ["depth24"]})"}}};
        return planOf(describe(sketch), traits).passes[0];
    };
    const PlanPass pass = drawn("x");
    REQUIRE(pass.has_depth);
    CHECK(pass.depth.target >= 0);
    CHECK(pass.depth.load == LoadOp::clear);
    CHECK(pass.depth.clear[0] == 1.0f);
    CHECK(pass.depth.store == StoreOp::discard);
    CHECK(pass.color[0].store == StoreOp::store);
    CHECK(drawn("x d").depth.store == StoreOp::store);
    SceneTraits reversed;
    reversed.reversed_depth = true;
    CHECK(drawn("x", reversed).depth.clear[0] == 0.0f);
}

TEST_CASE("Targets whose lifetimes do not meet share a texture")
{
    const Description description =
        describe(Sketch{{"a: -> w", "b: w -> x", "c: x -> y", "d: y -> z"}, {{"out", "z"}}});
    const Plan plan = planOf(description);
    CHECK(plan.textures.size() == 2);
    CHECK(plan.textures[0].targets == std::vector<std::string>{"w", "y"});
    CHECK(plan.texture_bytes == 2 * 64 * 32);
    CHECK(planOf(description, {}, keeping("aliasing")).textures.size() == 4);
}

TEST_CASE("In graphs of every shape no two live targets share a texture and reads follow writes")
{
    std::mt19937 random(7);
    const auto below = [&random](std::size_t limit) { return random() % limit; };
    for (int round = 0; round < 60; ++round) {
        std::vector<std::string> passes, targets;
        for (std::size_t i = 0, count = 2 + below(9); i < count; ++i) {
            std::set<std::string> reads;
            for (std::size_t n = below(3); n > 0 && !targets.empty(); --n)
                reads.insert(targets[below(targets.size())]);
            std::string line = "p" + std::to_string(i) + ":";
            for (const auto& each : reads) line += " " + each;
            line += " ->";
            for (std::size_t n = 1 + below(2); n > 0; --n) {
                targets.push_back("t" + std::to_string(targets.size()));
                line += " " + targets.back();
            }
            const auto place = static_cast<std::ptrdiff_t>(below(passes.size() + 1));
            passes.insert(passes.begin() + place, line);
        }
        const Plan plan = planOf(describe(
            Sketch{passes, {{"last", targets.back()}, {"other", targets[below(targets.size())]}}}));
        for (std::size_t i = 0; i < plan.targets.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const PlanTarget& a = plan.targets[j];
                const PlanTarget& b = plan.targets[i];
                const bool meet = a.first_pass <= b.last_pass && b.first_pass <= a.last_pass;
                CHECK_FALSE((meet && a.texture == b.texture));
            }
        }
        for (int p = 0; p < static_cast<int>(plan.passes.size()); ++p)
            for (const PlanInput& input : plan.passes[p].inputs) {
                CHECK(plan.targets[input.index].first_pass < p);
                CHECK(plan.targets[input.index].last_pass >= p);
            }
    }
}

TEST_CASE(
    "Depth that nobody reads may be a part of a larger texture that is free, and no other target")
{
    const auto plan = [](const char* scratch, const char* output) {
        return planOf(describe(
            Sketch{{R"(first: -> a | "type": "draw", "depth": "wide")", "middle: wide a -> b",
                    std::string(R"(last: b -> lit | "type": "draw", "depth": ")") + scratch + "\""},
                   {{"color", output}},
                   {{"wide", R"({"format": ["depth24"], "size": {"scale": 1.5}})"},
                    {"a", R"({"format": ["r8"], "size": {"scale": 1.5}})"},
                    {"near", R"({"format": ["depth24"]})"},
                    {"other", R"({"format": ["depth16"]})"}},
                   R"("imports": {"scene": {"type": "draw_list"}})"}));
    };
    const Plan shared = plan("near", "lit");
    const PlanAttachment* scratch = attachmentOf(shared, "near");
    CHECK(shared.targets[scratch->target].texture ==
          shared.targets[attachmentOf(shared, "wide")->target].texture);
    CHECK(scratch->store == StoreOp::discard);
    const Plan formats = plan("other", "lit");
    CHECK(formats.targets[attachmentOf(formats, "other")->target].texture !=
          formats.targets[attachmentOf(formats, "wide")->target].texture);
    CHECK(shared.targets[attachmentOf(shared, "lit")->target].texture !=
          shared.targets[attachmentOf(shared, "a")->target].texture);
}
