// SPDX-License-Identifier: MIT
// Each optimization has work in what ships; one that has none is to be deleted.
// Shipped configs on what a host has of a surface: the passes that remain, and what is left out.
// What GLSL ES leaves to chance is written: a sampler without a precision is lowp, which holds 8
// bits, and a literal has the precision of what it meets.
#include <crevice/config.h>
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "tests/support/plan_rig.h"
#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/planning.h"
#include "tools/show/plan/print.h"

#include <glm/gtc/matrix_transform.hpp>

#include <regex>

using namespace crevice;

namespace {

/// Two draws of which the camera shows the first, with a light.
Frame frameOn(RecordingDevice& device)
{
    Frame frame;
    const MeshId mesh =
        need(device.createMesh({"cube", std::vector<Vertex>(3), {0, 1, 2, 2, 1, 0}}));
    frame.camera.clip_from_view = glm::perspective(0.8f, 2.0f, 0.1f, 50.0f);
    frame.materials.resize(1);
    frame.lights.resize(1);
    for (const double x : {0.0, 100.0}) {
        DrawItem item = {mesh, 0, 6, glm::translate(glm::dmat4(1), glm::dvec3(x, 0, -5)), 0};
        item.bounds_radius = 1;
        frame.draws.push_back(item);
    }
    return frame;
}

/// The calls that a config makes on a device in two equal frames, and what its plan says is left
/// out.
struct Run {
    std::string log;
    std::vector<Elided> elided;
};

Run runOf(const Description& description, std::vector<std::string> outputs, const std::string& kept)
{
    RecordingDevice device;
    const Frame frame = frameOn(device);
    CompileOptions options;
    options.extent = {64, 32};
    options.outputs = std::move(outputs);
    if (!kept.empty()) options.disable = {kept};
    const auto renderer = need(Renderer::create(device, description, options, traitsOf(frame)));
    need(renderer->render(frame));
    need(renderer->render(frame));
    return {device.log(), allElided(renderer->plan())};
}

/// Whether the optimization changes the device calls, and the plan says so: of the config as
/// it is, without occlusion, or asked for the occlusion alone.
bool fires(const std::string& optimization, const std::string& config)
{
    const Description whole = descriptionOf({config, ""});
    Description without = whole;
    for (ParamDesc& param : without.params)
        if (param.name == "intensity") param.value[0] = 0.0f;
    const std::vector<std::string> occlusion = {"ao"};
    for (const auto& [description, outputs] :
         {std::pair{whole, std::vector<std::string>()}, {without, {}}, {whole, occlusion}}) {
        const Run with = runOf(description, outputs, "");
        bool said = false;
        for (const Elided& each : with.elided) said = said || each.optimization == optimization;
        if (said && with.log != runOf(description, outputs, optimization).log) return true;
    }
    return false;
}

const char* const kPresets[] = {"mobile_low", "mobile",        "balanced", "balanced_temporal",
                                "high",       "reference",     "quality",  "gtao",
                                "bitmask",    "bitmask_layers"};

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
    CHECK(toText(plan.diagnostics()) == "");
    return need(std::move(plan));
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

/// The precision of a sampler that the text declares, empty where the declaration has none.
std::string precisionOf(const std::string& text, const std::string& sampler)
{
    const std::regex declaration("uniform\\s+(?:(highp|mediump|lowp)\\s+)?sampler2D(?:MS)?\\s+" +
                                 sampler + "\\s*;");
    std::smatch found;
    return std::regex_search(text, found, declaration) ? found[1].str() : "";
}

/// Whether half floats lose what a texture holds.
bool isWide(Format format)
{
    const FormatInfo& info = formatInfo(format);
    return info.format_class == FormatClass::depth ||
           (info.format_class == FormatClass::floating && info.bytes == 4 * info.channels);
}

bool isWide(const Plan& plan, const PlanInput& input)
{
    if (input.kind != InputKind::target && input.kind != InputKind::history) return false;
    return isWide(plan.textures[plan.targets[input.index].texture].format);
}

}  // namespace

TEST_CASE("Every optimization fires in at least three shipped configs")
{
    for (const std::string& optimization : namesOf(kOptimizations)) {
        int configs = 0;
        for (const std::string& config : configNames(shippedSources()))
            if (configs < 3 && fires(optimization, config)) ++configs;
        INFO(optimization);
        CHECK(configs == 3);
    }
}

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
            CHECK(renderer->render(frame).diagnostics().at(0).code == Code::missing_import);
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

TEST_CASE("Every sampler of a shipped shader has a precision, and no literal is shifted by a count")
{
    const std::regex bare("uniform\\s+sampler");
    // Which is converted in the same expression.
    const std::regex shift("\\b[0-9]\\w*\\s*<<\\s*u?int\\s*\\(");
    CHECK(std::regex_search("1u << uint(max(first, last) + 0.5)", shift));
    CHECK_FALSE(std::regex_search("1 << (level - 1)", shift));
    for (const std::string& path : shippedSources().list()) {
        INFO(path);
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, bare));
        CHECK_FALSE(std::regex_search(shippedSources().find(path)->text, shift));
    }
}

TEST_CASE("What reads depth or 32-bit floats in a shipped config has a highp sampler for it")
{
    for (const Subject& subject : subjects()) {
        const Description description =
            need(loadDescription({subject.config, subject.variant, {}, {}}, shippedSources()));
        const Plan plan = need(compile(description, usualTraits(), usualCaps(), {kUsualExtent}));
        for (const PlanPass& pass : plan.passes)
            for (const PlanInput& input : pass.inputs) {
                if (input.name.empty() || !isWide(plan, input)) continue;
                INFO(subject.config << " " << subject.variant << ", pass " << pass.name << ", "
                                    << input.name);
                CHECK(precisionOf(plan.programs[pass.program].fragment.text, input.name) ==
                      "highp");
            }
    }
}
