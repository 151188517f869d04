// SPDX-License-Identifier: MIT
// Every shipped config and variant with mediump in half floats, against the same at full precision.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include "tools/render/device/open_device.h"
#include "tools/render/scene/camera_framing.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

// Most that the mean occlusion may change: a quarter of a step of the 8 bits it is stored in.
// Measured figures are in docs/reference/precision.md.
constexpr double kMostChange = 0.001;

/// The radius is 0.8 in units of one. Marches have as many taps in all configs: their programs are
/// then the same, and in half floats one takes software GL ten seconds to compile. What the config
/// gives in scene units is in that unit too.
Description describe(const Subject& subject, float unit)
{
    std::vector<std::string> overrides = {"radius=0.8"};
    Description description = descriptionOf(subject, overrides);
    if (const ParamDesc* slices = findNamed(description.params, "slices")) {
        const bool many = slices->value[0] > 8;
        overrides.push_back(many ? "slices=4" : "slices=2");
        overrides.push_back(many ? "steps=8" : "steps=4");
        description = descriptionOf(subject, overrides);
    }
    for (ParamDesc& param : description.params)
        if (param.unit == "scene units") param.value[0] *= unit;
    return description;
}

/// All of it in another unit.
Scene inUnits(Scene scene, float unit)
{
    const glm::dmat4 to_unit = glm::scale(glm::dmat4(1.0), glm::dvec3(unit));
    for (SceneInstance& instance : scene.instances)
        instance.world_from_model = to_unit * instance.world_from_model;
    for (SceneCamera& camera : scene.cameras) {
        camera.view_from_world[3] *= glm::dvec4(glm::dvec3(unit), 1.0);
        camera.near_distance *= unit;
        camera.far_distance *= unit;
    }
    return scene;
}

struct Setting {
    Scene scene;
    Extent extent;
    float unit = 1.0f;
};

/// A device with scenes on it.
class Stage : public DrawRig {
public:
    Stage(Mediump mediump, const std::vector<Setting>& settings) : settings_(settings)
    {
        device = need(makeMediumpDevice(std::move(device), mediump));
        for (const Setting& setting : settings) {
            scenes_.push_back(need(UploadedScene::upload(*device, setting.scene)));
            const double aspect = double(setting.extent.width) / setting.extent.height;
            frames_.push_back(
                makeFrame(scenes_.back(),
                          need(chooseCamera(setting.scene, scenes_.back().bounds(), "", aspect)),
                          setting.extent));
        }
    }

    /// The occlusion of the second frame, whose history is the first, and whether all that any pass
    /// of it wrote is finite.
    std::pair<Image, bool> drawn(std::size_t setting, Description description)
    {
        const Frame& frame = frames_[setting];
        const CompileOptions options = {settings_[setting].extent, {}, {}};
        const Plan plan = need(compile(description, traitsOf(frame), device->caps(), options));
        for (const PlanTarget& target : plan.targets) {
            OutputDesc output;
            output.name = "target_" + target.name;
            output.target.name = target.name;
            description.outputs.push_back(output);
        }
        Renderer& renderer = reloaded(description, frame, options);
        for (int i = 0; i < 2; ++i) need(renderer.render(frame));
        bool finite = true;
        for (const PlanOutput& output : renderer.plan().outputs)
            for (const float value : read(renderer.output(output.name)).pixels)
                finite = finite && std::isfinite(value);
        return {read(renderer.output("ao")), finite};
    }

private:
    std::vector<Setting> settings_;
    std::vector<UploadedScene> scenes_;
    std::vector<Frame> frames_;
};

/// Software GL is one and the same behind both contexts.
bool applies() { return canRewriteMediump() && testBackend() == "egl"; }

}  // namespace

TEST_CASE("In half floats all that shipped configs draw is finite, and occlusion as it was")
{
    if (!applies()) return;
    // Software GL takes minutes to compile the programs of all, so by day one preset meets the
    // smallest units, and what follows is left to the night.
    std::vector<std::pair<Subject, std::vector<std::size_t>>> asked = {{{"mobile"}, {2}}};
    if (nightly()) {
        asked.clear();
        for (const Subject& subject : subjects())
            asked.push_back({subject, subject.variant.empty() ? std::vector<std::size_t>{0, 1, 2, 3}
                                                              : std::vector<std::size_t>{0}});
    }
    const Scene room = need(loadScene("room"));
    const std::vector<Setting> settings = {{room, {256, 144}},
                                           {need(loadScene("plane")), {128, 72}},
                                           {inUnits(room, 1e-3f), {4096, 1}, 1e-3f},
                                           {inUnits(room, 1e3f), {2600, 2}, 1e3f}};
    Stage full(Mediump::full, settings), half(Mediump::half, settings);
    for (const auto& [subject, chosen] : asked)
        for (const std::size_t i : chosen) {
            INFO(subject.config << " " << subject.variant << ", setting " << i);
            const Description description = describe(subject, settings[i].unit);
            const Image exact = full.drawn(i, description).first;
            const auto [rounded, finite] = half.drawn(i, description);
            CHECK(finite);
            CHECK(allVisibility(rounded));
            CHECK(meanChange(exact, rounded) < kMostChange);
            if (mean(exact) >= 0.999) CHECK(mean(rounded) >= 0.999);
        }
}
