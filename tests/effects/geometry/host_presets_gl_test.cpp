// SPDX-License-Identifier: MIT
// Presets on a host's textures give the picture of the same preset that draws what they hold.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/host_textures.h"

#include <cmath>

using namespace crevice;

namespace {

using Overrides = std::vector<std::string>;

/// A scene, and configs that draw it or get it from a host.
struct Hosted : SceneRig {
    Frame seen = frame();

    Hosted() : SceneRig("spheres", {160, 90}) {}

    Image occlusion(const std::string& config, const Overrides& overrides, int frames = 1)
    {
        const Description description = descriptionOf({config}, overrides);
        HostTextures host = need(HostTextures::make(*device, description, extent, seen));
        return draw(description, need(host.frameOf(seen)), "ao", frames);
    }
};

}  // namespace

TEST_CASE("A preset on a host's surface is the same preset drawn, without band, backs and layers")
{
    const std::tuple<const char*, const char*, Overrides> presets[] = {
        {"mobile", "+geometry/host_depth", {"guard_band=1"}},
        {"mobile_temporal", "+geometry/host_depth", {"guard_band=1"}},
        {"gtao", "+geometry/host_depth_normal", {"guard_band=1"}},
        {"balanced", "+geometry/host_depth_normal", {"guard_band=1", "back_faces=false"}},
        {"balanced_temporal", "+geometry/host_depth_normal", {"guard_band=1", "back_faces=false"}},
        {"high", "+geometry/host_depth_normal", {"guard_band=1", "back_faces=false"}},
    };
    Hosted hosted;
    for (const auto& [preset, module, drawn] : presets) {
        INFO(preset);
        const Image ours = hosted.occlusion(preset, drawn, 4);
        CHECK(mean(ours) < 0.98);
        CHECK(meanChange(hosted.occlusion(preset, {module}, 4), ours) < 1e-4);
    }
}

TEST_CASE("What a host stores in another way gives the same picture, from cameras of any kind")
{
    Hosted hosted;
    for (const char* camera : {"", "eye=0.6,0.9,2.2;at=0,0.3,0;fov=50"}) {
        hosted.seen = hosted.frame(camera);
        const Image ours = hosted.occlusion("gtao", {"+geometry/host_depth_normal"});
        CHECK(mean(ours) < 0.98);
        for (const char* module : {"linear_depth_normal", "log_depth_normal", "position_normal"}) {
            INFO(camera << ' ' << module);
            const Image other = hosted.occlusion("gtao", {std::string("+geometry/host_") + module});
            CHECK(meanChange(other, ours) < 0.003);
        }
    }
}

TEST_CASE("A host's textures are in its own view space, and in its own format")
{
    Hosted hosted;
    const Image upright = hosted.occlusion("gtao", {"+geometry/host_depth_normal"});
    const glm::dmat4 mirror = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
    Camera& camera = hosted.seen.camera;
    camera.view_from_world = mirror * camera.view_from_world;
    camera.clip_from_view = glm::mat4(glm::dmat4(camera.clip_from_view) * mirror);
    for (const char* module : {"depth_normal", "position_normal"}) {
        INFO(module);
        const Image other = hosted.occlusion("gtao", {std::string("+geometry/host_") + module});
        CHECK(meanChange(other, upright) < 0.003);
    }

    const Description coarse =
        descriptionOf({"mobile"}, {"+geometry/host_depth", "/imports/depth/format=depth16"});
    HostTextures host =
        need(HostTextures::make(*hosted.device, coarse, hosted.extent, hosted.seen));
    const Frame frame = need(host.frameOf(hosted.seen));
    REQUIRE(frame.textures.size() == 1);
    for (const float value : hosted.read(frame.textures[0].texture).pixels)
        REQUIRE(std::abs(value * 65535 - std::round(value * 65535)) < 0.02f);
    CHECK(frame.draws.empty());
}

TEST_CASE("Each of two eyes gets a host's textures of its own")
{
    Hosted hosted;
    Camera other = hosted.seen.camera;
    other.view_from_world[3][0] += 0.5;
    hosted.seen.other_views = {{other, {}}};
    const Description mobile = descriptionOf({"mobile"}, {"+geometry/host_depth"});
    HostTextures host =
        need(HostTextures::make(*hosted.device, mobile, hosted.extent, hosted.seen));
    const Frame both = need(host.frameOf(hosted.seen));
    const auto renderer = hosted.renderer(mobile, both, {"ao"});
    need(renderer->render(both));
    const Image left = hosted.read(renderer->output("ao", 0));
    const Image right = hosted.read(renderer->output("ao", 1));
    hosted.seen.other_views.clear();
    CHECK(meanChange(hosted.occlusion("mobile", {"+geometry/host_depth"}), left) == 0.0);
    hosted.seen.camera = other;
    CHECK(meanChange(hosted.occlusion("mobile", {"+geometry/host_depth"}), right) == 0.0);
}
