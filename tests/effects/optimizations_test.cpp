// SPDX-License-Identifier: MIT
// Each optimization has work in what ships; one that has none is to be deleted.
#include <crevice/recording_device.h>
#include <crevice/renderer.h>

#include "tests/support/shipped_subjects.h"
#include "tools/show/plan/costs.h"

#include <glm/gtc/matrix_transform.hpp>

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
