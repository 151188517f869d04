// SPDX-License-Identifier: MIT
// What holds for every shipped config and each of its variants, on the built-in scenes and on
// random ones, however the camera projects.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/render/scene_upload.h"
#include "tools/scene/builtin_scenes.h"
#include "tools/scene/camera_framing.h"
#include "tools/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <random>

using namespace crevice;

namespace {

constexpr Extent kExtent = {128, 72};

// Directions and noise are not mirrored along. Most for the unrotated cube of ogldev45, 0.011, then
// the one slice at half the size of mobile_low, 0.008; below 0.006 for all others.
constexpr double kMirrorBound = 0.013;

const char* const kCentred = "eye=0,3,6;at=0,0.5,0;fov=45";
const char* const kOffCentre = "eye=1,2,5;at=0,0.5,0;fov=45;shift=0.3,-0.2";
const char* const kOrthographic = "eye=2,3,5;at=0,0.5,0;ortho=4";

/// A floor with boxes, bars and spheres on it; the same seed gives the same scene everywhere.
Scene randomScene(unsigned seed)
{
    std::mt19937 engine(seed);
    const auto between = [&engine](float low, float high) {
        return low + (high - low) * float(engine() >> 8) / float(1 << 24);
    };
    Scene scene;
    scene.materials.resize(1);
    scene.meshes.push_back(makeBox({-4, -0.2f, -4}, {4, 0, 4}));
    for (int i = 0; i < 4; ++i) {
        const float half = between(0.1f, 0.5f), bar = between(0.02f, 0.06f);
        scene.meshes.push_back(makeBox({-half, -0.01f, -half}, {half, between(0.2f, 1.2f), half}));
        scene.meshes.push_back(makeBox({-bar, -0.01f, -bar}, {bar, between(0.5f, 2.0f), bar}));
        scene.meshes.push_back(makeSphere(between(0.15f, 0.5f), 16));
    }
    scene.instances.resize(scene.meshes.size());
    for (std::size_t i = 1; i < scene.meshes.size(); ++i) {
        scene.meshes[i].label = "object";
        const glm::vec3 place = {between(-2, 2), 0, between(-2, 2)};
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), place);
        scene.instances[i].mesh = int(i);
        scene.instances[i].world_from_model = glm::rotate(moved, between(0, 3), glm::vec3(0, 1, 0));
    }
    return scene;
}

/// The config as it ships, but for counts of taps that software GL takes seconds for.
Description describe(const Subject& subject)
{
    LoadRequest request = {subject.config, subject.variant, {"radius=0.8"}};
    const auto load = [&request] {
        return need(decode(need(loadConfig(shippedSources(), request)), shippedSources()));
    };
    Description description = load();
    if (findNamed(description.params, "contrast")) {  // above 1 it clips all but creases to white
        request.overrides.push_back("contrast=1");
        description = load();
    }
    const ParamDesc* slices = findNamed(description.params, "slices");
    if (!slices || slices->value[0] <= 8) return description;
    request.overrides.insert(request.overrides.end(), {"slices=4", "steps=8"});
    return load();
}

/// Kernels without normals probe inside every wall, and find it grey; those without guards find
/// steps of the stored positions.
bool openOnWalls(const Description& description)
{
    const FeatureDesc* guards = findNamed(description.features, "guards");
    if (guards && guards->value == 0) return false;
    for (const PassDesc& pass : description.passes)
        for (const Reference& color : pass.color)
            if (color.name == "ao") {
                const ShaderDesc* shader = findNamed(description.shaders, pass.shader.name);
                const std::string& text = description.files.at(shader->fragment.name)->text;
                return text.find("SURFACE_WITHOUT_NORMAL") == std::string::npos;
            }
    return true;
}

/// The mean of 9x9 pixels: without the noise that a few random vectors leave.
Image softened(const Image& image)
{
    constexpr int kReach = 4;
    const Extent size = image.extent;
    Image soft(size, 1);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            float sum = 0;
            for (int j = y - kReach; j <= y + kReach; ++j)
                for (int i = x - kReach; i <= x + kReach; ++i)
                    sum += image.at(std::clamp(i, 0, size.width - 1),
                                    std::clamp(j, 0, size.height - 1));
            soft.at(x, y) = sum / ((2 * kReach + 1) * (2 * kReach + 1));
        }
    return soft;
}

float least(const Image& image)
{
    return *std::min_element(image.pixels.begin(), image.pixels.end());
}

/// A scene on the device that all tests of a case share.
struct Set {
    Scene scene;
    UploadedScene uploaded;

    Set(Device& device, Scene shown)
        : scene(std::move(shown)),
          uploaded(need(UploadedScene::upload(device, scene)))
    {
    }

    Frame frame(const std::string& camera) const
    {
        const double aspect = double(kExtent.width) / kExtent.height;
        Frame made = makeFrame(
            uploaded, need(chooseCamera(scene, uploaded.bounds(), camera, aspect)), kExtent);
        made.camera_cut = true;
        return made;
    }
};

std::unique_ptr<Renderer> makeRenderer(GlFixture& gl, const Subject& subject, const Frame& frame)
{
    return need(
        Renderer::create(*gl.device, describe(subject), {kExtent, {"ao"}, {}}, traitsOf(frame)));
}

Image draw(GlFixture& gl, Renderer& renderer, const Frame& frame)
{
    need(renderer.render(frame));
    return gl.read(renderer.output("ao"));
}

}  // namespace

TEST_CASE("Shipped configs and variants draw visibility on the built-in scenes, 1 on a plane")
{
    GlFixture gl;
    std::vector<Set> sets;
    for (const std::string& name : builtinSceneNames())
        sets.emplace_back(*gl.device, need(loadScene(name)));
    for (const Subject& subject : subjects()) {
        auto renderer = makeRenderer(gl, subject, sets.front().frame(""));
        for (const Set& set : sets) {
            INFO(subject.config << " " << subject.variant << " " << set.scene.name);
            const Image ao = draw(gl, *renderer, set.frame(""));
            CHECK(allVisibility(ao));
            const bool plane = set.scene.name == "plane";
            if (!plane) CHECK(mean(ao) < 0.999);
            if (plane && openOnWalls(renderer->description())) CHECK(least(ao) > 0.95f);
        }
    }
}

TEST_CASE("Shipped configs and variants see random scenes in every projection, mirrored too")
{
    GlFixture gl;
    std::vector<Set> sets, swapped;
    for (const unsigned seed : {1u, 2u, 3u}) {
        sets.emplace_back(*gl.device, randomScene(seed));
        swapped.emplace_back(*gl.device, mirrored(randomScene(seed)));
    }
    std::size_t turn = 0;
    for (const Subject& subject : subjects()) {
        INFO(subject.config << " " << subject.variant);
        const std::size_t seed = turn++ % sets.size();
        const Frame centred = sets[seed].frame(kCentred);
        auto renderer = makeRenderer(gl, subject, centred);
        const Image plain = draw(gl, *renderer, centred);
        for (const char* camera : {kOffCentre, kOrthographic}) {
            const Image ao = draw(gl, *renderer, sets[(seed + 1) % sets.size()].frame(camera));
            INFO(camera);
            CHECK(allVisibility(ao));
            CHECK(mean(ao) < 0.999);
        }
        const Image other = mirrored(draw(gl, *renderer, swapped[seed].frame(kCentred)));
        CHECK(allVisibility(plain));
        const Image soft = softened(plain), soft_other = softened(other);
        CHECK(meanChange(soft, soft_other) < kMirrorBound);
        CHECK(meanChange(soft, soft_other) < 0.75 * meanChange(soft, mirrored(soft)));
        need(renderer->setParam("intensity", 0.0f));
        CHECK(least(draw(gl, *renderer, centred)) == 1.0f);
    }
}
