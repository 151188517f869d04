// SPDX-License-Identifier: MIT
// What differs between two plans: passes, their shaders, inputs and sizes, textures and bytes.
#include "tools/show/plan/diff.h"

#include "tests/support/catch.h"
#include "tests/support/plan_rig.h"

using namespace crevice;

namespace {

using Kind = PlanChange::Kind;

const PlanChange* changeOf(const PlanDiff& diff, const std::string& section,
                           const std::string& name)
{
    for (const PlanChange& change : diff.changes)
        if (change.section == section && change.name == name) return &change;
    return nullptr;
}

/// "before -> after" of a property; "" where it did not change.
std::string property(const PlanChange* change, const std::string& name)
{
    if (!change) return "no such change";
    for (const auto& each : change->properties)
        if (each.name == name) return each.before + " -> " + each.after;
    return {};
}

Plan plan(const std::string& half_size = "", const char* format = "r8")
{
    return planOf(
        describe({{"ssao: -> ao", "blur: ao -> smooth"},
                  {{"ao", "smooth"}},
                  {{"ao", std::string(R"({"format": [")") + format + "\"]" + half_size + "}"}}}));
}

}  // namespace

TEST_CASE("Equal plans differ in nothing, and their totals are the same")
{
    const PlanDiff diff = diffPlans(plan(), plan());
    CHECK(diff.changes.empty());
    for (const PlanTotal& total : diff.totals) CHECK(total.before == total.after);
    CHECK(toText(diff).find("passes: 2 -> 2\n") != std::string::npos);
}

TEST_CASE("A pass and its target on one side only are printed with all that they are")
{
    const PlanDiff diff = diffPlans(plan(), planOf(describe({{"ssao: -> ao"}, {{"ao", "ao"}}})));
    const PlanChange* blur = changeOf(diff, "passes", "blur");
    REQUIRE(blur);
    CHECK(blur->kind == Kind::only_before);
    CHECK(property(blur, "fragment") == "blur.frag -> ");
    CHECK(changeOf(diff, "targets", "smooth")->kind == Kind::only_before);
    CHECK(property(changeOf(diff, "outputs", "ao"), "from") == "target smooth -> target ao");
    CHECK(diff.totals[0].name == "passes");
    CHECK(diff.totals[0].after == 1);
    const PlanDiff back = diffPlans(planOf(describe({{"ssao: -> ao"}, {{"ao", "ao"}}})), plan());
    CHECK(changeOf(back, "passes", "blur")->kind == Kind::only_after);
}

TEST_CASE("A size and a format that changed are printed with the bytes that they cost")
{
    const PlanDiff diff = diffPlans(plan(), plan(R"(, "size": {"scale": 0.5})", "rgba16f"));
    const PlanChange* ao = changeOf(diff, "targets", "ao");
    CHECK(property(ao, "format") == "r8 -> rgba16f");
    CHECK(property(ao, "size") == "64x32 -> 32x16");
    const PlanChange* ssao = changeOf(diff, "passes", "ssao");
    CHECK(property(ssao, "size") == "64x32 -> 32x16");
    CHECK(property(ssao, "written") == "2.0 KiB -> 4.0 KiB");
    CHECK(property(ssao, "type").empty());
    CHECK(diff.totals[2].name == "texture_bytes");
    CHECK(diff.totals[2].after - diff.totals[2].before == 2048);
    CHECK(toText(diff).find("texture bytes: 4.0 KiB -> 6.0 KiB (+2.0 KiB)") != std::string::npos);
}

TEST_CASE("Defines, inputs and what a sampler reads are listed by name")
{
    const auto with = [](const char* count, const char* input) {
        Description description =
            describe(std::string(R"({"format": 1, "name": "two",
                "params": {"taps": {"type": "int", "default": )") +
                         count + R"(, "bind": "define"}},
                "targets": {"a": {"format": ["r8"]}, "b": {"format": ["r8"]}, "c": {"format": ["r8"]}},
                "shaders": {"one": {"vertex": "full.vert", "fragment": "one.frag"},
                            "mix": {"vertex": "full.vert", "fragment": "mix.frag"}},
                "passes": {"one": {"shader": "one", "color": ["a", "b"]},
                           "mix": {"shader": "mix", "color": "c", "inputs": {"source": )" +
                         input + R"(}}},
                "outputs": {"a": "a", "b": "b", "c": "c"}})",
                     {{"full.vert", kFullVertex},
                      {"one.frag",
                       "#version 300 es\nprecision highp float;\n"
                       "layout(location = 0) out vec4 x;\nlayout(location = 1) out vec4 y;\n"},
                      {"mix.frag",
                       "#version 300 es\nprecision highp float;\nconst int n = TAPS;\n"
                       "uniform sampler2D source;\nlayout(location = 0) out vec4 z;\n"}});
        return planOf(description);
    };
    const PlanDiff diff =
        diffPlans(with("4", "\"a\""), with("8", R"({"from": "b", "filter": "linear"})"));
    const PlanChange* mix = changeOf(diff, "passes", "mix");
    CHECK(property(mix, "define TAPS") == "4 -> 8");
    CHECK(property(mix, "input source") == "target a (nearest, clamp) -> target b (linear, clamp)");
    CHECK(changeOf(diff, "passes", "one") == nullptr);
    const std::string json = toJson(diff);
    CHECK(json.find(R"({"name": "define TAPS", "before": "4", "after": "8"})") !=
          std::string::npos);
}

TEST_CASE("A diff says by what mask and within what a pass is drawn, and no write of the mask")
{
    const auto drawn = [](const std::string& keys) {
        return planOf(
            describe(Sketch{{R"(geometry: -> normal | "type": "draw", "frustum_scale": 1)",
                             R"(mask: normal -> | "depth": "mask", "state": {"depth_write": true})",
                             R"(ao: normal -> ao | "mask": "mask", "clear": {"ao": 1})" + keys},
                            {{"ao", "ao"}},
                            {{"mask", R"({"format": ["depth16"], "semantic": "mask"})"}},
                            R"("imports": {"scene": {"type": "draw_list"}})"}));
    };
    const PlanDiff diff = diffPlans(drawn(""), drawn(R"(, "scissor": true)"));
    const PlanChange* ao = changeOf(diff, "passes", "ao");
    CHECK(property(ao, "drawn within") == "everything -> the bounds of all draws");
    CHECK(property(ao, "writes mask") == "");
    const PlanDiff kept = diffPlans(
        drawn(""),
        planOf(describe(Sketch{
            {R"(geometry: -> normal | "type": "draw", "frustum_scale": 1)", "ao: normal -> ao"},
            {{"ao", "ao"}},
            {},
            R"("imports": {"scene": {"type": "draw_list"}})"})));
    const std::string text = toText(kept);
    CHECK(text.find("writes mask") == text.npos);
    CHECK(text.find("input  =") == text.npos);
}
