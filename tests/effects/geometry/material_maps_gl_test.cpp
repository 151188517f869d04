// SPDX-License-Identifier: MIT
// The maps of materials: normals, what an alpha test cuts away, and baked occlusion.
// Far taps read coarser copies of depth, each texel of which is one of depth.
// Presets on a host's textures give the picture of the same preset that draws what they hold.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/host_textures.h"

#include <glm/geometric.hpp>

#include <cmath>

using namespace crevice;

namespace {

/// A wall of one unit square at z = 0 that fills most of the picture of kFront.
Scene wall()
{
    Scene scene;
    MeshDesc mesh;
    mesh.label = "wall";
    const glm::vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const glm::vec2& at : corners)
        mesh.vertices.push_back({{at.x - 0.5f, at.y - 0.5f, 0}, {0, 0, 1}, {at.x, at.y}});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes = {mesh};
    scene.instances.resize(1);
    scene.materials.resize(1);
    return scene;
}

const char* const kFront = "eye=0,0,2;at=0,0,0;fov=25";

SceneTexture oneColor(const glm::vec4& color)
{
    SceneTexture texture{"color", Image({2, 2}, 4)};
    for (int i = 0; i < 16; ++i) texture.image.pixels[i] = color[i % 4];
    return texture;
}

Image target(const std::string& name, const Scene& scene, const std::string& camera = kFront,
             const std::string& config = "hemisphere_box")
{
    SceneRig rig(scene);
    return rig.draw(showing(descriptionOf({config}), name), rig.frame(camera), "shown");
}

glm::vec3 normalInTheMiddle(const Scene& scene, const char* camera = kFront)
{
    const Image image = target("normal", scene, camera);
    const glm::vec3 stored(image.at(64, 36, 0), image.at(64, 36, 1), image.at(64, 36, 2));
    return glm::normalize(stored * 2.0f - 1.0f);
}

/// Two steps of 24 bits, by which a value may move when it is stored once more.
constexpr float kStep = 2e-7f;

/// Whether `depth` has that value somewhere in the block of 2^level texels on a side.
bool holds(const Image& depth, int level, int x, int y, float value)
{
    for (int v = y << level; v < (y + 1) << level; ++v)
        for (int u = x << level; u < (x + 1) << level; ++u)
            if (std::abs(depth.at(u, v) - value) < kStep) return true;
    return false;
}

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

TEST_CASE("A normal map tilts the normal towards growing u and v, from whichever side and scale")
{
    Scene scene = wall();
    const glm::vec3 tilted = glm::normalize(glm::vec3(0.6f, 0.3f, 0.7f));
    scene.textures = {oneColor(glm::vec4(tilted * 0.5f + 0.5f, 1.0f))};
    scene.materials[0].normal_texture = 0;
    const auto points = [&](const char* camera, const glm::vec3& wanted) {
        return glm::distance(normalInTheMiddle(scene, camera), glm::normalize(wanted)) < 0.02f;
    };
    CHECK(points(kFront, tilted));
    CHECK(points("eye=0,0,-2;at=0,0,0;fov=25", tilted * glm::vec3(-1, 1, 1)));
    scene.instances[0].world_from_model = glm::mat4(glm::mat3(1e-6f));
    CHECK(points("eye=0,0,2e-6;at=0,0,0;fov=25", tilted));
    scene.instances[0].world_from_model = glm::mat4(1.0f);
    scene.materials[0].normal_scale = 0.5f;
    CHECK(points(kFront, tilted * glm::vec3(0.5f, 0.5f, 1.0f)));

    // One without a map, beside another that has one.
    scene.materials.push_back({});
    scene.instances.push_back(scene.instances[0]);
    scene.instances[0].material = 1;
    scene.instances[1].world_from_model[3] = glm::vec4(9, 9, 9, 1);
    CHECK(points(kFront, {0, 0, 1}));
}

TEST_CASE("What the alpha test cuts away is background to all that follows")
{
    Scene scene = wall();
    SceneTexture holes{"holes", Image({2, 1}, 4, 1.0f)};
    holes.image.at(0, 0, 3) = 0.0f;
    scene.textures = {holes};
    scene.materials[0].base_color_texture = 0;
    scene.materials[0].alpha_cutoff = 0.5f;
    const Image normal = target("normal", scene);
    CHECK(normal.at(50, 36, 3) == 0.0f);
    CHECK(normal.at(78, 36, 3) == 1.0f);
    CHECK(target("ao_filtered", scene).at(50, 36) == 1.0f);
}

TEST_CASE("Baked occlusion joins that of the screen by the lesser of both")
{
    Scene scene = wall();
    scene.textures = {oneColor({0.4f, 1, 1, 1})};
    CHECK(target("ao_filtered", scene, kFront, "baked").at(64, 36) > 0.98f);
    scene.materials[0].occlusion_texture = 0;
    CHECK(target("ao_joined", scene, kFront, "baked").at(64, 36) == Approx(0.4).margin(0.01));
    scene.materials[0].occlusion_strength = 0.5f;
    CHECK(target("ao_joined", scene, kFront, "baked").at(64, 36) == Approx(0.7).margin(0.01));
    CHECK(target("ao_joined", scene, kFront, "baked").at(1, 1) == 1.0f);
}

TEST_CASE("A texel of a level is one of the texels of depth that it stands for")
{
    SceneRig rig("room", {97, 53});
    const Description description =
        GivenConfig({"gtao", "geometry/depth_levels"}).description({"guard_band=1"});
    const auto target = [&](const char* name) {
        return rig.draw(showing(description, name), rig.frame(), "shown");
    };
    const Image levels = target("depth_levels"), depth = target("depth");
    REQUIRE(levels.extent == depth.extent);
    const Extent corners[] = {{0, 0}, {48, 0}, {48, 13}, {48, 13 + 6}};
    for (int level = 1; level <= 4; ++level) {
        INFO(level);
        for (int y = 0; y < 53 >> level; ++y)
            for (int x = 0; x < 97 >> level; ++x) {
                const Extent corner = corners[level - 1];
                CHECK(holds(depth, level, x, y, levels.at(corner.width + x, corner.height + y)));
            }
    }
}

TEST_CASE("A preset on a host's surface is the same preset drawn, without band, backs and layers")
{
    const std::tuple<const char*, const char*, Overrides> presets[] = {
        {"mobile", "+geometry/host_depth", {"guard_band=1"}},
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
