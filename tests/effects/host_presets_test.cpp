// SPDX-License-Identifier: MIT
// Shipped configs on what a host has of a surface: the passes that remain, and what is left out.
#include "tests/support/plan_rig.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"

#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

using namespace crevice;

namespace {

const char* const kPresets[] = {
    "mobile_low",    "mobile",    "mobile_temporal", "balanced", "balanced_temporal",
    "high",          "reference", "quality",         "gtao",     "bitmask",
    "bitmask_layers"};

/// A module, and the textures that it reads.
const std::pair<const char*, std::vector<std::string>> kHosts[] = {
    {"geometry/host_depth", {"depth"}},
    {"geometry/host_depth_normal", {"depth", "normal"}},
    {"geometry/host_linear_depth_normal", {"linear_depth", "normal"}},
    {"geometry/host_log_depth", {"log_depth"}},
    {"geometry/host_position_normal", {"position", "normal"}},
};

Description presetOn(const std::string& preset, const std::string& module)
{
    return descriptionOf({preset}, {"+" + module});
}

Plan planOn(const Description& description)
{
    CompileOptions options;
    options.extent = {256, 144};
    Result<Plan> plan = compile(description, usualTraits(), usualCaps(), options);
    INFO(toText(plan.diagnostics()));
    REQUIRE(plan);
    CHECK(plan.diagnostics().empty());
    return std::move(*plan);
}

/// The passes between the scene and the light, by name: among those that are ready the order is
/// that of the document, which other modules lead. A host has no layers.
std::vector<std::string> occlusionPasses(const Plan& plan)
{
    std::vector<std::string> names;
    for (const PlanPass& pass : plan.passes)
        if (pass.type == PassType::fullscreen && pass.name != "lighting" &&
            pass.name != "host_distance" && pass.name != "source_layers")
            names.push_back(pass.name);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

TEST_CASE("Every preset runs on a host's surface: it draws nothing, and computes occlusion as ever")
{
    for (const char* preset : kPresets)
        for (const auto& [module, textures] : kHosts) {
            INFO(preset << " on " << module);
            const Plan drawn = planOn(descriptionOf({preset}));
            const Plan plan = planOn(presetOn(preset, module));
            CHECK(occlusionPasses(plan) == occlusionPasses(drawn));
            for (const PlanPass& pass : plan.passes) CHECK(pass.type == PassType::fullscreen);
            REQUIRE(plan.outputs.size() == 1);
            CHECK(plan.outputs[0].name == "ao");
            for (const ImportDesc& import : plan.imports)
                CHECK((import.type == ImportType::camera ||
                       std::count(textures.begin(), textures.end(), import.name) == 1));
            CHECK((elided(plan, "module geometry/back_faces") == nullptr) ==
                  (findNamed(drawn.passes, "back_faces") == nullptr &&
                   std::string(preset) != "quality"));

            // It runs with those textures alone, and asks for each.
            RecordingDevice device(usualCaps());
            Frame frame;
            auto renderer = need(Renderer::create(device, presetOn(preset, module),
                                                  {{64, 36}, {}, {}}, traitsOf(frame)));
            const Status missing = renderer->render(frame);
            REQUIRE_FALSE(missing);
            CHECK(missing.diagnostics().front().code == Code::missing_import);
            for (const std::string& name : textures) {
                const TextureId id = need(device.createTexture({name, Format::rgba16f, {64, 36}}));
                need(device.writeTexture(id, Image({64, 36}, 4)));
                frame.textures.push_back({name, id});
            }
            need(renderer->render(frame));
            need(renderer->render(frame));
            CHECK(device.misuse().empty());
        }
}
