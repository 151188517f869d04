// SPDX-License-Identifier: MIT
// Scenes on a device, and the frames made from them.
// Built-in camera paths: where they end, and how far what is seen moves from frame to frame.
#include "tools/render/scene_upload.h"

#include <crevice/recording_device.h>

#include "tests/support/need.h"
#include "tools/render/camera_path.h"
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

constexpr int kFrames = 32;

PathView view(bool orthographic)
{
    PathView view;
    view.extent = {200, 100};
    view.distance = 6.0;
    view.camera.view_from_world =
        glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0, 1, 0), glm::dvec3(0, 1, 0));
    view.camera.orthographic = orthographic;
    view.camera.half_height = 2.0;
    view.camera.near_distance = 0.1;
    view.camera.far_distance = 100.0;
    return view;
}

/// The pixel at which a frame sees a point that the last one has in its view space.
glm::dvec2 seen(const PathView& view, const CameraPath& path, int frame, const glm::dvec3& point,
                int frames = kFrames)
{
    const SceneCamera camera = cameraAt(path, view, frame, frames);
    const glm::dvec4 clip = glm::dmat4(clipFromView(camera, view.extent, {})) *
                            camera.view_from_world * glm::inverse(view.camera.view_from_world) *
                            glm::dvec4(point, 1.0);
    return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) *
           glm::dvec2(view.extent.width, view.extent.height);
}

/// Pixels that the point has moved in the last frame.
glm::dvec2 movedBy(const PathView& view, const char* path, const glm::dvec3& point)
{
    const CameraPath found = need(findCameraPath(path));
    return seen(view, found, kFrames - 1, point) - seen(view, found, kFrames - 2, point);
}

void checkMoved(const glm::dvec2& moved, double right, double up)
{
    CHECK(moved.x == Approx(right).margin(0.02));
    CHECK(moved.y == Approx(up).margin(0.002));
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

TEST_CASE("camera paths move the middle of the picture by their pixels a frame")
{
    for (const bool orthographic : {false, true}) {
        const PathView end = view(orthographic);
        const glm::dvec3 middle(0, 0, -6), near(0, 0, -3);
        checkMoved(movedBy(end, "still", middle), 0, 0);
        checkMoved(movedBy(end, "pan", middle), -5, 0);
        checkMoved(movedBy(end, "pan", near), -5, 0);
        checkMoved(movedBy(end, "strafe", middle), -3, 0);
        checkMoved(movedBy(end, "strafe", near), orthographic ? -3 : -6, 0);
        CHECK(glm::length(movedBy(end, "sub-pixel", middle)) == Approx(0.15).margin(0.001));
        CHECK(movedBy(end, "sub-pixel", middle).y < -0.05);
    }
}

TEST_CASE("the path that uncovers jumps once, sixteen frames before its end or halfway")
{
    const PathView end = view(false);
    const CameraPath path = need(findCameraPath("disocclusion"));
    const glm::dvec3 middle(0, 0, -6);
    for (const auto& [frames, jump] : {std::pair(32, 16), {100, 84}, {10, 5}, {2, 1}})
        for (int frame = 0; frame < frames; ++frame) {
            INFO(frame << " of " << frames);
            const double at = seen(end, path, frame, middle, frames).x;
            CHECK(at == Approx(frame < jump ? 132 : 100).margin(0.01));
        }
}
