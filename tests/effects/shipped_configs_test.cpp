// SPDX-License-Identifier: MIT
// What holds for every shipped config before any GL: it loads, plans, and stays short.
#include <crevice/compile.h>
#include <crevice/recording_device.h>

#include "core/base/text.h"
#include "core/run/dirty_passes.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/print.h"

#include <algorithm>

using namespace crevice;

namespace {

using Names = std::vector<std::string>;

Plan planOf(const Description& description, Names outputs = {}, bool material_ambient = false)
{
    SceneTraits traits;
    traits.lights = 1;
    traits.material_ambient = material_ambient;
    return need(compile(description, traits, generousCaps(), {{256, 144}, std::move(outputs), {}}));
}

}  // namespace

TEST_CASE("A still frame of a shipped config without history runs no pass")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Plan plan = planOf(descriptionOf({name}));
        const bool remembers =
            std::any_of(plan.targets.begin(), plan.targets.end(),
                        [](const PlanTarget& each) { return each.history_texture >= 0; });
        if (remembers) continue;
        PassCache cache(plan);
        const std::vector<char> still(plan.passes.size(), 0);
        cache.choose(std::vector<char>(plan.passes.size(), 1));
        const std::vector<char>& runs = cache.choose(still);
        CHECK(std::count(runs.begin(), runs.end(), 1) == 0);
    }
}

TEST_CASE("Every shipped config plans on a full and on a bare device")
{
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Description description = descriptionOf({name});
        CHECK(!planOf(description).passes.empty());
        const bool float_positions = findNamed(description.targets, "position") != nullptr;
        const Result<Plan> result = compile(description, {}, minimumCaps(), {{64, 64}, {}, {}});
        CHECK(result.ok() == !float_positions);
        if (!result.ok()) CHECK(result.diagnostics().front().code == Code::no_format);
    }
}

TEST_CASE(
    "Every attachment of a shipped config is as large as its pass, on a device that wants it so")
{
    DeviceCaps caps = generousCaps();
    caps.equal_attachments = true;
    for (const std::string& name : configNames(shippedSources())) {
        INFO(name);
        const Plan plan = need(compile(descriptionOf({name}), {}, caps, {{256, 144}, {}, {}}));
        for (const PlanPass& pass : plan.passes) {
            std::vector<PlanAttachment> attachments = pass.color;
            if (pass.has_depth) attachments.push_back(pass.depth);
            for (const PlanAttachment& each : attachments) {
                if (each.target < 0) continue;
                const PlanTarget& target = plan.targets[each.target];
                CHECK(plan.textures[target.texture].extent == pass.extent);
                CHECK(plan.textures[target.drawn_texture].extent == pass.extent);
            }
        }
    }
}

TEST_CASE("250 offsets without rotation plan on a device that holds them, and say so on others")
{
    Description description =
        descriptionOf({"hemisphere_box"}, {"samples=250", "/generated/rotation_noise/count=1"});
    CHECK(!planOf(description).passes.empty());
    const auto planned = [&] {
        return compile(description, {}, minimumCaps(), {{64, 64}, {}, {}});
    };
    const Result<Plan> refused = planned();
    REQUIRE(refused.diagnostics().size() == 1);
    const Diagnostic& error = refused.diagnostics()[0];
    CHECK(error.code == Code::too_many);
    CHECK(error.pointer == "/params/samples");
    int most = 250;
    for (ParamDesc& param : description.params)
        while (param.name == "samples" && most > 1 && !planned().ok())
            param.value[0] = static_cast<float>(--most);
    const std::string vectors = std::to_string(250 - most + 224);
    CHECK_THAT(error.message, Catch::Contains(vectors) && Catch::Contains("224"));
    CHECK_THAT(error.help, Catch::Contains("to " + std::to_string(most)));
}

TEST_CASE("Every config says what it is in 25 lines or fewer, and every param what it does")
{
    for (const std::string& name : configNames(shippedSources())) {
        const std::string& text = shippedSources().find("configs/" + name + ".json")->text;
        const Description description = descriptionOf({name});
        INFO(name);
        CHECK(std::count(text.begin(), text.end(), '\n') <= 25);
        CHECK(description.name == name);
        CHECK(!description.text.empty());
        for (const ParamDesc& param : description.params) {
            INFO(param.name);
            CHECK(!param.tooltip.empty());
            CHECK(!param.unit.empty());
        }
    }
}

TEST_CASE("A config runs what its outputs need, and a no-op leaves out what it stands for")
{
    struct Case {
        const char* config;
        Names overrides;
        Names outputs;
        const char* passes;
    };
    for (const Case& each :
         {Case{"learnopengl", {}, {}, "geometry, foreground, ssao, filter, lighting"},
          Case{"learnopengl", {}, {"ao"}, "geometry, foreground, ssao, filter"},
          Case{"learnopengl", {"display=no_ao"}, {"color"}, "geometry, lighting"},
          Case{"learnopengl", {"intensity=0"}, {"color"}, "geometry, lighting"},
          Case{"learnopengl", {"radius=0"}, {"color"}, "geometry, lighting"},
          Case{"hemisphere_bilateral",
               {},
               {},
               "geometry, foreground, ssao, filter_x, filter_y, lighting"},
          Case{"sphere_box", {}, {}, "geometry, foreground, ssao, filter, lighting"}}) {
        const Plan plan = planOf(descriptionOf({each.config}, each.overrides), each.outputs);
        INFO(each.config << ' ' << joined(each.overrides) << " for " << joined(each.outputs));
        CHECK(joined(namesOf(plan.passes)) == each.passes);
        if (!each.overrides.empty()) CHECK(!plan.elided.empty());
    }
}

TEST_CASE("A config has the targets that its outputs and the scene's materials need alone")
{
    struct Case {
        const char* config;
        Names outputs;
        bool material_ambient;
        const char* target;
        bool there;
    };
    for (const Case& each :
         {Case{"learnopengl", {"ao"}, false, "albedo", false},
          Case{"learnopengl", {"ao"}, false, "normal", true},
          Case{"sphere_box", {"ao"}, false, "normal", false},  // nothing else reads normals
          Case{"sphere_box", {"color"}, false, "normal", true},
          Case{"learnopengl", {}, true, "ambient_factor", true},
          Case{"gtao", {}, true, "ambient_factor", true},
          Case{"baked", {}, true, "ambient_factor", true},
          Case{"mobile", {}, true, "ambient_factor", false},  // which is lit as it is drawn
          Case{"gtao", {"ao"}, true, "ambient_factor", false},
          Case{"mobile", {"ao"}, true, "ambient_factor", false}}) {
        const Description description = descriptionOf({each.config});
        const Plan plan = planOf(description, each.outputs, each.material_ambient);
        INFO(each.config << ", " << each.target << " for " << joined(each.outputs));
        CHECK((findNamed(plan.targets, each.target) != nullptr) == each.there);
        CHECK(toText(planOf(description)).find("ambient_factor") == std::string::npos);
    }
}

TEST_CASE("A device's own variant of a config takes a few lines")
{
    // Half resolution, fewer taps, a smaller G-buffer, for any shipped config.
    MemorySources mine;
    mine.add("configs/phone.json", R"({
  "format": 1,
  "name": "phone",
  "extends": ["learnopengl"],
  "params": { "samples": { "default": 8 } },
  "targets": {
    "ao": { "size": { "scale": 0.5 } },
    "normal": { "format": ["rgb10_a2"] }
  }
})");
    const LayeredSources sources({&mine, &shippedSources()});
    const Plan plan = need(
        compile(descriptionOf({"phone"}, {}, sources), {}, generousCaps(), {{101, 51}, {}, {}}));
    CHECK(findNamed(plan.passes, "ssao")->extent == Extent{51, 26});
    CHECK(findNamed(plan.passes, "filter")->extent == Extent{101, 51});
}

TEST_CASE("thesis dims everything, and its variant the ambient light alone")
{
    const Description whole = descriptionOf({"thesis"});
    const Description ambient = descriptionOf({"thesis", "ambient_only"});
    CHECK(findNamed(whole.features, "ao_on")->value == 1);
    CHECK(findNamed(ambient.features, "ao_on")->value == 0);
}
