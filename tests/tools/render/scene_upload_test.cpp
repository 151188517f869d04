// SPDX-License-Identifier: MIT
// Scenes on a device, and the frames made from them.
#include "tools/render/scene_upload.h"

#include <crevice/recording_device.h>

#include "tests/support/need.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

// Two boxes of one mesh, an empty mesh, a textured and a plain material.
Scene makeScene()
{
    Scene scene;
    scene.meshes = {MeshDesc(), makeBox({0, 0, 0}, {1, 1, 1})};
    scene.textures = {{"bricks", Image({4, 2}, 4, 0.25f)}};
    scene.materials.resize(2);
    scene.materials[1].base_color_texture = 0;
    scene.materials[1].specular = glm::vec3(0.5f);
    scene.materials[1].shininess = 99;
    scene.materials[1].alpha_cutoff = 0.4f;
    scene.instances = {{0}, {1, glm::mat4(1), 1}, {1, glm::translate(glm::mat4(1), {5, 0, 0}), 0}};
    scene.lights.resize(1);
    scene.ambient_light = glm::vec3(0.1f);
    return scene;
}

}  // namespace

TEST_CASE("a frame has every instance with triangles, its materials' textures, and its camera")
{
    RecordingDevice device;
    const UploadedScene uploaded = need(UploadedScene::upload(device, makeScene()));
    SceneCamera camera;
    camera.view_from_world = glm::lookAt(glm::vec3(0, 0, 9), glm::vec3(0), glm::vec3(0, 1, 0));
    const Frame frame = makeFrame(uploaded, camera, {16, 9});
    REQUIRE(frame.draws.size() == 2);
    CHECK(frame.draws[0].mesh.value == frame.draws[1].mesh.value);
    CHECK(frame.draws[0].count == 36);
    CHECK(frame.draws[0].material == 1);
    CHECK(frame.draws[1].world_from_model[3].x == 5);
    CHECK(device.live(ObjectId::Kind::mesh) == 1);
    CHECK(frame.lights.size() == 1);
    CHECK(frame.ambient_light == glm::vec3(0.1f));

    CHECK_FALSE(frame.materials[0].base_color_map);
    REQUIRE(frame.materials[1].base_color_map);
    const Image texture = need(device.readTexture(frame.materials[1].base_color_map));
    CHECK(texture.extent == Extent{4, 2});
    CHECK(texture.at(3, 1, 0) == 0.25f);
    CHECK(frame.materials[1].specular == glm::vec3(0.5f));
    CHECK(frame.materials[1].shininess == 99);
    CHECK(frame.materials[1].alpha_cutoff == 0.4f);

    CHECK(frame.camera.view_from_world == camera.view_from_world);
    CHECK(frame.camera.clip_from_view == clipFromView(camera, {16, 9}, makeScene().bounds()));
}

TEST_CASE("an uploaded scene takes its objects along and leaves none behind")
{
    RecordingDevice device;
    {
        UploadedScene first = need(UploadedScene::upload(device, makeScene()));
        UploadedScene second = need(UploadedScene::upload(device, makeScene()));
        CHECK(device.live() == 4);
        UploadedScene moved = std::move(first);
        CHECK(device.live() == 4);
        moved = std::move(second);
        CHECK(device.live() == 2);
    }
    CHECK(device.live() == 0);
    CHECK(device.misuse().empty());
}

TEST_CASE("an upload that fails half way leaves nothing on the device")
{
    for (int failing = 1; failing <= 3; ++failing) {
        RecordingDevice device;
        device.failAt(failing);
        CHECK_FALSE(UploadedScene::upload(device, makeScene()).ok());
        CHECK(device.live() == 0);
    }
}
