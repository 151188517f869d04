// SPDX-License-Identifier: MIT
// Presets on a host's textures give the picture of the same preset that draws what they hold.
#include "tests/support/picture.h"

#include <crevice/config.h>
#include <crevice/renderer.h>
#include <crevice/shipped.h>

#include "tools/render/host_textures.h"
#include "tools/render/scene_upload.h"
#include "tools/scene/camera_framing.h"

#include <cmath>

using namespace crevice;

namespace {

using Overrides = std::vector<std::string>;

/// A scene, and configs that draw it or get it from a host.
struct Hosted {
    GlFixture gl;
    Scene scene = need(loadScene("spheres"));
    UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    Extent extent = {160, 90};
    Frame frame;

    explicit Hosted(const char* camera = "")
    {
        const double aspect = double(extent.width) / extent.height;
        frame = makeFrame(uploaded, need(chooseCamera(scene, uploaded.bounds(), camera, aspect)),
                          extent);
    }

    Image occlusion(const std::string& config, const Overrides& overrides, int frames = 1)
    {
        const Description description = need(
            decode(need(loadConfig(shippedSources(), {config, "", overrides})), shippedSources()));
        HostTextures host = need(HostTextures::make(*gl.device, description, extent, frame));
        const Frame hosted = need(host.frameOf(frame));
        const auto renderer =
            need(Renderer::create(*gl.device, description, {extent, {"ao"}, {}}, traitsOf(hosted)));
        for (int i = 0; i < frames; ++i) need(renderer->render(hosted));
        return gl.read(renderer->output("ao"));
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
    for (const char* camera : {"", "eye=0.6,0.9,2.2;at=0,0.3,0;fov=50"}) {
        Hosted hosted(camera);
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
    hosted.frame.camera.view_from_world = mirror * hosted.frame.camera.view_from_world;
    hosted.frame.camera.clip_from_view =
        glm::mat4(glm::dmat4(hosted.frame.camera.clip_from_view) * mirror);
    for (const char* module : {"depth_normal", "position_normal"}) {
        INFO(module);
        const Image other = hosted.occlusion("gtao", {std::string("+geometry/host_") + module});
        CHECK(meanChange(other, upright) < 0.003);
    }

    const Description coarse = need(decode(
        need(loadConfig(shippedSources(),
                        {"mobile", "", {"+geometry/host_depth", "/imports/depth/format=depth16"}})),
        shippedSources()));
    HostTextures host =
        need(HostTextures::make(*hosted.gl.device, coarse, hosted.extent, hosted.frame));
    const Frame frame = need(host.frameOf(hosted.frame));
    REQUIRE(frame.textures.size() == 1);
    for (const float value : hosted.gl.read(frame.textures[0].texture).pixels)
        REQUIRE(std::abs(value * 65535 - std::round(value * 65535)) < 0.02f);
    CHECK(frame.draws.empty());
}

TEST_CASE("Each of two eyes gets a host's textures of its own")
{
    Hosted hosted;
    Camera other = hosted.frame.camera;
    other.view_from_world[3][0] += 0.5;
    hosted.frame.other_views = {{other, {}}};
    const Description mobile =
        need(decode(need(loadConfig(shippedSources(), {"mobile", "", {"+geometry/host_depth"}})),
                    shippedSources()));
    HostTextures host =
        need(HostTextures::make(*hosted.gl.device, mobile, hosted.extent, hosted.frame));
    const Frame both = need(host.frameOf(hosted.frame));
    const auto renderer = need(
        Renderer::create(*hosted.gl.device, mobile, {hosted.extent, {"ao"}, {}}, traitsOf(both)));
    need(renderer->render(both));
    const Image left = hosted.gl.read(renderer->output("ao", 0));
    const Image right = hosted.gl.read(renderer->output("ao", 1));
    hosted.frame.other_views.clear();
    CHECK(meanChange(hosted.occlusion("mobile", {"+geometry/host_depth"}), left) == 0.0);
    hosted.frame.camera = other;
    CHECK(meanChange(hosted.occlusion("mobile", {"+geometry/host_depth"}), right) == 0.0);
}
