// SPDX-License-Identifier: MIT
// Scenes as bytes: the same scene comes out, and nothing but an error out of what is none.
#include "tools/render/scene/scene_bytes.h"

#include "tests/support/need.h"
#include "tools/render/scene/builtin_scenes.h"

#include <random>

using namespace crevice;

namespace {

// One of each, with nothing at its default.
Scene smallScene()
{
    Scene scene;
    scene.name = "small";
    scene.meshes = {{"mesh", {{{1, 2, 3}, {0, 1, 0}, {0.25f, 0.5f}}, {{4, 5, 6}}, {}}, {0, 1, 2}}};
    scene.instances = {{0, glm::dmat4(3.0), 0}};
    scene.textures = {{"texture", Image({2, 1}, 4, 0.5f)}};
    scene.materials = {{"material", {1, 0, 0, 1}, 0, {1, 1, 1}, 8.0f, 0.5f, -1, 2.0f, -1, 0.75f}};
    scene.cameras = {{"camera", glm::dmat4(2.0), true, 0.5, 3.0, {0.25, 0.5}, 0.1, 90.0}};
    scene.lights = {{"light", {}}};
    scene.lights[0].light.spot = true;
    scene.lights[0].light.outer_angle_rad = 0.9f;
    scene.ambient_light = {0.25f, 0.5f, 0.75f};
    return scene;
}

Code codeOf(std::string_view bytes)
{
    const Result<Scene> scene = sceneFromBytes(bytes);
    return scene ? Code() : scene.diagnostics().at(0).code;
}

}  // namespace

TEST_CASE("a scene comes out of its bytes as it went in")
{
    const std::string bytes = sceneBytes(smallScene());
    const Scene read = need(sceneFromBytes(bytes));
    CHECK(sceneBytes(read) == bytes);
    const std::string street = sceneBytes(*builtinScene("street"));
    CHECK(sceneBytes(*sceneFromBytes(street)) == street);
    CHECK(read.name == "small");
    CHECK(read.meshes[0].vertices[1].position[2] == 6.0f);
    CHECK(read.textures[0].image.extent == Extent{2, 1});
    CHECK(read.cameras[0].far_distance == 90.0);
    CHECK(read.lights[0].light.outer_angle_rad == 0.9f);
    CHECK(read.ambient_light.z == 0.75f);  // the last of all
}

TEST_CASE("a scene's bytes do not depend on the size of a word")
{
    Scene scene;
    scene.name = "ab";
    const std::string bytes = sceneBytes(scene);
    CHECK(bytes.substr(8, 10) == std::string("\2\0\0\0\0\0\0\0ab", 10));
    constexpr std::size_t kLists = 7;
    CHECK(bytes.size() == 8 + 8 + 2 + kLists * 8 + 3 * sizeof(float));
    CHECK(sceneBytes(smallScene()).size() == 809);  // in a 32-bit program, too
}

TEST_CASE("bytes of a scene that are cut anywhere are an error")
{
    const std::string bytes = sceneBytes(smallScene());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string cut = bytes.substr(0, size);  // with no byte behind it
        INFO(size << " of " << bytes.size());
        CHECK(codeOf(cut) == Code::scene_broken);
    }
    CHECK(codeOf(bytes + "x") == Code::scene_broken);
}

TEST_CASE("bytes of a scene that are changed at random are a scene or an error")
{
    const std::string bytes = sceneBytes(smallScene());
    std::mt19937 random(1);
    int errors = 0;
    for (int round = 0; round < 20000; ++round) {
        std::string changed = bytes;
        for (int change = 0; change < 3; ++change)
            changed[random() % changed.size()] = static_cast<char>(random());
        const Result<Scene> scene = sceneFromBytes(changed);
        if (scene) (void)scene->bounds();
        errors += scene ? 0 : 1;
    }
    CHECK(errors > 1000);
}

TEST_CASE("a length that no memory holds is an error before it is taken")
{
    std::string bytes = sceneBytes(Scene());
    for (std::size_t at = 8; at + 8 <= bytes.size() - 3 * sizeof(float); at += 8)
        for (const char* length :
             {"\xff\xff\xff\xff\xff\xff\xff\xff", "\1\0\0\0\0\0\0\x20", "\0\0\0\0\0\x10\0\0"}) {
            std::string claimed = bytes;
            claimed.replace(at, 8, std::string(length, 8));
            INFO(at);
            CHECK(codeOf(claimed) == Code::scene_broken);
        }
}

TEST_CASE("a scene whose bytes refer to what is not in them is an error")
{
    const auto codeAfter = [](void (*change)(Scene&)) {
        Scene scene = smallScene();
        change(scene);
        return codeOf(sceneBytes(scene));
    };
    void (*const broken[])(Scene&) = {[](Scene& s) { s.instances[0].mesh = 1; },
                                      [](Scene& s) { s.instances[0].mesh = -1; },
                                      [](Scene& s) { s.instances[0].material = 1; },
                                      [](Scene& s) { s.materials[0].normal_texture = 1; },
                                      [](Scene& s) { s.materials[0].normal_texture = -2; },
                                      [](Scene& s) { s.meshes[0].indices[0] = 3; },
                                      [](Scene& s) { s.meshes[0].indices.pop_back(); },
                                      [](Scene& s) { s.textures[0].image.extent.width = 3; },
                                      [](Scene& s) { s.textures[0].image.channels = 0; }};
    for (const auto& change : broken) CHECK(codeAfter(change) == Code::scene_broken);
    CHECK(codeAfter([](Scene& s) { s.instances.clear(); }) == Code::scene_empty);
    CHECK(codeAfter([](Scene&) {}) == Code());
}
