// SPDX-License-Identifier: MIT
// Presets on a host's textures give the picture of the same preset that draws what they hold.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/host_textures.h"

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
    for (auto [preset, module, drawn] : presets) {
        INFO(preset);
        Overrides theirs = {module};
        const Image ours = hosted.occlusion(preset, drawn, 4);
        CHECK(mean(ours) < 0.98);
        if (std::string_view(module) == "+geometry/host_depth_normal") {
            // A host has no planes: they are rebuilt from its depth.
            CHECK(meanChange(hosted.occlusion(preset, theirs, 4), ours) < 2e-3);
            for (Overrides* each : {&theirs, &drawn}) each->push_back("shading_normals=false");
        }
        CHECK(meanChange(hosted.occlusion(preset, theirs, 4), hosted.occlusion(preset, drawn, 4)) <
              1e-4);
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

TEST_CASE("A host's textures are in its own view space")
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
}

TEST_CASE("Distances of a host count as surfaces above 0 and below the far, and nowhere else")
{
    // A sphere kernel shades all surfaces, and no background.
    const Description description =
        GivenConfig({"geometry/host_linear_depth", "ssao/sphere", "filter/none"},
                    R"(, "params": {"linear_far": 10})")
            .description();
    SceneRig rig("spheres");
    Frame bare;
    bare.camera = rig.frame().camera;
    const auto occlusionAt = [&](float distance) {
        const TextureId image = rig.texture(Format::r32f, rig.extent);
        need(rig.device->writeTexture(image, Image(rig.extent, 1, distance)));
        bare.textures = {{"linear_depth", image}};
        return 1 - mean(rig.draw(description, bare));
    };
    for (const float distance : {5.0f, 9.9f}) CHECK(occlusionAt(distance) > 0.1);
    for (const float distance : {-5.0f, 0.0f, 10.0f, 11.0f}) CHECK(occlusionAt(distance) == 0);
}
