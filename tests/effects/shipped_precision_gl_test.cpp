// SPDX-License-Identifier: MIT
// Every shipped config and variant with mediump in half floats, against the same at full precision.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/device/mediump_device.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/builtin_scenes.h"
#include "tools/scene/camera_framing.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <regex>

using namespace crevice;

namespace {

// Most that the mean occlusion may change: a quarter of a step of the 8 bits it is stored in.
// Measured figures are in docs/reference/precision.md.
constexpr double kMostChange = 0.001;

/// The radius is 0.8 in units of one. Marches have as many taps in all configs: their programs are
/// then the same, and in half floats one takes software GL ten seconds to compile. What the config
/// gives in scene units is in that unit too.
Description describe(const Subject& subject, const SourceSet& sources, float unit)
{
    LoadRequest request = {subject.config, subject.variant, {"radius=0.8"}};
    const auto load = [&] { return need(decode(need(loadConfig(sources, request)), sources)); };
    Description description = load();
    if (const ParamDesc* slices = findNamed(description.params, "slices")) {
        const bool many = slices->value[0] > 8;
        request.overrides.push_back(many ? "slices=4" : "slices=2");
        request.overrides.push_back(many ? "steps=8" : "steps=4");
        description = load();
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
class Stage {
public:
    Stage(Mediump mediump, const std::vector<Setting>& settings)
    {
        gl_.device = need(makeMediumpDevice(std::move(gl_.device), mediump));
        for (const Setting& setting : settings) {
            UploadedScene scene = need(UploadedScene::upload(*gl_.device, setting.scene));
            const double aspect = double(setting.extent.width) / setting.extent.height;
            const SceneCamera camera =
                need(chooseCamera(setting.scene, scene.bounds(), "", aspect));
            const Frame frame = makeFrame(scene, camera, setting.extent);
            sets_.push_back({std::move(scene), frame, setting.extent});
        }
    }

    /// The occlusion of the second frame, whose history is the first.
    Image drawAo(std::size_t setting, const Description& description)
    {
        draw(sets_[setting], description, {"ao"});
        return gl_.read(renderer_->output("ao"));
    }

    /// The same, and whether all that any pass of that frame wrote is finite.
    Image drawAll(std::size_t setting, Description description, bool& finite)
    {
        exposeTargets(sets_[setting], description);
        draw(sets_[setting], description, {});
        finite = true;
        for (const PlanOutput& output : renderer_->plan().outputs)
            finite = finite && isFinite(gl_.read(renderer_->output(output.name)));
        return gl_.read(renderer_->output("ao"));
    }

private:
    struct Set {
        UploadedScene scene;
        Frame frame;
        Extent extent;
    };

    /// One renderer draws everything, since it keeps the programs that it has.
    void draw(const Set& set, const Description& description, std::vector<std::string> outputs)
    {
        const CompileOptions options = {set.extent, std::move(outputs), {}};
        if (renderer_)
            need(renderer_->reload(description, options));
        else
            renderer_ =
                need(Renderer::create(*gl_.device, description, options, traitsOf(set.frame)));
        need(renderer_->render(set.frame));
        need(renderer_->render(set.frame));
    }

    void exposeTargets(const Set& set, Description& description) const
    {
        const Plan plan = need(
            compile(description, traitsOf(set.frame), gl_.device->caps(), {set.extent, {}, {}}));
        for (const PlanTarget& target : plan.targets) {
            OutputDesc output;
            output.name = "target_" + target.name;
            output.target.name = target.name;
            description.outputs.push_back(output);
        }
    }

    static bool isFinite(const Image& image)
    {
        return std::all_of(image.pixels.begin(), image.pixels.end(),
                           [](float value) { return std::isfinite(value); });
    }

    GlFixture gl_;
    std::vector<Set> sets_;
    std::unique_ptr<Renderer> renderer_;
};

/// Software GL is one and the same behind both contexts.
bool applies() { return canRewriteMediump() && testBackend() == "egl"; }

/// Shipped sources that say mediump wherever they said highp.
class CarelessSources : public SourceSet {
public:
    SourceRef find(std::string_view path) const override
    {
        const SourceRef source = shippedSources().find(path);
        if (!source || path.substr(path.rfind('.') + 1) == "json") return source;
        SourceText careless = *source;
        careless.text = std::regex_replace(careless.text, std::regex("\\bhighp\\b"), "mediump");
        return std::make_shared<SourceText>(careless);
    }
    std::vector<std::string> list() const override { return shippedSources().list(); }
};

}  // namespace

TEST_CASE("In half floats all that shipped configs draw is finite, and occlusion as it was")
{
    if (!applies()) return;
    const Scene room = need(loadScene("room"));
    const std::vector<Setting> settings = {{room, {256, 144}},
                                           {need(loadScene("plane")), {128, 72}},
                                           {inUnits(room, 1e-3f), {4096, 1}, 1e-3f},
                                           {inUnits(room, 1e3f), {2600, 2}, 1e3f}};
    Stage full(Mediump::full, settings), half(Mediump::half, settings);
    for (const Subject& subject : subjects())
        for (std::size_t i = 0; i < (subject.variant.empty() ? settings.size() : 1); ++i) {
            INFO(subject.config << " " << subject.variant << ", setting " << i);
            const Description description = describe(subject, shippedSources(), settings[i].unit);
            bool finite = false;
            const Image exact = full.drawAo(i, description);
            const Image rounded = half.drawAll(i, description, finite);
            CHECK(finite);
            CHECK(allVisibility(rounded));
            CHECK(meanChange(exact, rounded) < kMostChange);
            if (mean(exact) >= 0.999) CHECK(mean(rounded) >= 0.999);
        }
}

TEST_CASE("Shaders that say mediump everywhere fail in half floats and draw as ever in full")
{
    if (!applies()) return;
    const CarelessSources careless;
    const std::vector<Setting> settings = {
        {inUnits(need(loadScene("room")), 1e3f), {64, 36}, 1e3f}};
    Stage full(Mediump::full, settings), half(Mediump::half, settings);
    const Subject subject = {"gtao", ""};
    const Image exact = full.drawAo(0, describe(subject, shippedSources(), 1e3f));
    const Description description = describe(subject, careless, 1e3f);
    CHECK(full.drawAo(0, description).pixels == exact.pixels);
    CHECK(meanChange(exact, half.drawAo(0, description)) > 20 * kMostChange);
}
