// SPDX-License-Identifier: MIT
// Cameras: framing a scene, choosing one by name, reading one from text.
#include "tools/render/scene/camera_framing.h"

#include "core/base/text.h"
#include "tests/support/need.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

// A box of triangles.
Scene boxScene(const glm::vec3& low, const glm::vec3& high)
{
    Scene scene;
    scene.meshes = {makeBox(low, high)};
    scene.instances = {{0}};
    return scene;
}

const Bounds kBox = boxScene({-1, 0, -2}, {3, 2, 5}).bounds();

Result<SceneCamera> choose(const std::string& text)
{
    Scene scene;
    scene.cameras.resize(2);
    scene.cameras[0].name = "door";
    scene.cameras[1].name = "balcony";
    return chooseCamera(scene, kBox, text, 1.5);
}

glm::dvec3 eyeOf(const SceneCamera& camera)
{
    return glm::inverse(glm::dmat4(camera.view_from_world))[3];
}

// How far the scene reaches into the picture, from -1 to 1 in each direction; empty when some of it
// lies behind the camera.
Bounds clipBounds(const Scene& scene, const SceneCamera& camera, Extent extent)
{
    const glm::dmat4 clip_from_world = glm::dmat4(clipFromView(camera, extent, scene.bounds())) *
                                       glm::dmat4(camera.view_from_world);
    Bounds reached;
    bool behind = false;
    for (const SceneInstance& instance : scene.instances)
        for (const glm::vec3& corner : MeshCorners(scene.meshes[instance.mesh]).places) {
            const glm::dvec4 clip = clip_from_world * glm::dvec4(instance.place(corner), 1);
            behind |= clip.w <= 0;
            reached.add(glm::dvec3(clip) / clip.w);
        }
    return behind ? Bounds() : reached;
}

}  // namespace

TEST_CASE("a scene's own camera is taken unless it looks away from all of it")
{
    Scene scene = boxScene({-1, 0, -2}, {3, 2, 5});
    scene.cameras = {SceneCamera(), SceneCamera()};
    scene.cameras[0].name = "away";
    scene.cameras[1].name = "towards";
    scene.cameras[0].view_from_world = glm::lookAt(glm::dvec3(50, 1, 0), {99, 1, 0}, {0, 1, 0});
    scene.cameras[1].view_from_world = glm::lookAt(glm::dvec3(50, 1, 0), {0, 1, 0}, {0, 1, 0});
    const auto chosen = [&] { return need(chooseCamera(scene, scene.bounds(), "", 1.5)).name; };
    CHECK(chosen() == "towards");
    scene.cameras.pop_back();
    CHECK(chosen() == "framing");
}

TEST_CASE("a framed scene is seen whole from above, at any shape of it and the picture")
{
    const Scene shapes[] = {
        boxScene({-1, 0, -2}, {3, 2, 5}), boxScene({0, 0, 0}, {100, 0.1f, 0.1f}),
        boxScene({0, 0, 0}, {0.1f, 50, 0.1f}), boxScene({5, 5, 5}, {5.001f, 5.002f, 5}),
        boxScene({-1e6f, 0, -1e6f}, {1e6f, 1e5f, 1e6f})};
    for (const Scene& scene : shapes) {
        for (const Extent extent : {Extent{960, 540}, {100, 100}, {100, 900}, {2000, 100}}) {
            const double aspect = static_cast<double>(extent.width) / extent.height;
            const SceneCamera camera = frameScene(scene, aspect);
            CHECK(eyeOf(camera).y > scene.bounds().center().y);  // it looks down
            CHECK(glm::dmat4(camera.view_from_world)[1].y > 0.5);
            const Bounds reached = clipBounds(scene, camera, extent);
            REQUIRE_FALSE(reached.empty());
            for (int axis = 0; axis < 3; ++axis) {
                CHECK(reached.min[axis] > -1);
                CHECK(reached.max[axis] < 1);
            }
        }
    }
}

TEST_CASE("a scene that is one point, a line into the view or nothing can be framed")
{
    const glm::vec3 into = {0.55f, 0.45f, 1.0f};
    Scene line = boxScene({0, 0, 0}, {1, 1, 1});
    for (Vertex& vertex : line.meshes[0].vertices)
        for (int axis = 2; axis >= 0; --axis)
            vertex.position[axis] = vertex.position[0] * into[axis];
    for (const Scene& scene : {Scene(), boxScene({2, 2, 2}, {2, 2, 2}), line}) {
        const SceneCamera camera = frameScene(scene, 1.5);
        CHECK(std::isfinite(eyeOf(camera).x));
        CHECK(glm::determinant(camera.view_from_world) == Approx(1));
        if (!scene.meshes.empty()) CHECK_FALSE(clipBounds(scene, camera, {15, 10}).empty());
    }
}

TEST_CASE("a camera is chosen by its name; without one the first is taken, or the scene framed")
{
    CHECK(choose("balcony")->name == "balcony");
    CHECK(choose("")->name == "door");
    CHECK(chooseCamera(Scene(), kBox, "", 1.5)->name == "framing");
    CHECK(has(onlyError(choose("balcon"), Code::camera_missing).help, "'balcony'"));
}

TEST_CASE("a scene can be framed from any side, whatever cameras it has")
{
    Scene scene = boxScene({-1, 0, -2}, {3, 2, 5});
    scene.cameras.resize(1);
    const glm::dvec3 iso = eyeOf(frameScene(scene, 1.5)) - kBox.center();
    const std::pair<const char*, glm::dvec3> cases[] = {{"frame", iso},
                                                        {"frame=iso", iso},
                                                        {"frame=front", {0, 0, 1}},
                                                        {"frame=back", {0, 0, -1}},
                                                        {"frame=left", {-1, 0, 0}},
                                                        {"frame=right", {1, 0, 0}},
                                                        {"frame=top", {0, 1, 0}}};
    for (const auto& [text, towards_eye] : cases) {
        INFO(text);
        const SceneCamera camera = need(chooseCamera(scene, kBox, text, 1.5));
        const glm::dvec3 eye = eyeOf(camera) - kBox.center();
        CHECK(glm::dot(glm::normalize(eye), glm::normalize(towards_eye)) == Approx(1));
        const Bounds reached = clipBounds(scene, camera, {15, 10});
        REQUIRE_FALSE(reached.empty());
        CHECK(std::max(reached.max.x, reached.max.y) > 0.8);
        CHECK(std::max(reached.max.x, reached.max.y) < 1);
    }
    CHECK(has(onlyError(choose("frame=above"), Code::camera_missing).help,
              "frame=back, frame=front, frame=iso"));
}

TEST_CASE("a camera is read from text, and needs no more than an eye")
{
    const SceneCamera camera = need(choose("eye=4,2,6;at=0,1,0;up=0,0,1;fov=35;near=0.5;far=20"));
    CHECK(glm::length(eyeOf(camera) - glm::dvec3(4, 2, 6)) < 1e-5);
    CHECK(camera.fov_y_rad == Approx(35 * 3.14159265 / 180));
    CHECK(camera.near_distance == 0.5);
    CHECK(camera.far_distance == 20);
    CHECK_FALSE(camera.orthographic);
    const SceneCamera eye = need(choose("eye=9,9,9"));
    CHECK(eye.far_distance == 0);
    for (const auto& [looking, at] :
         {std::pair(camera, glm::dvec3(0, 1, 0)), {eye, kBox.center()}}) {
        const glm::dvec4 seen = glm::dmat4(looking.view_from_world) * glm::dvec4(at, 1);
        CHECK(glm::length(glm::dvec2(seen)) < 1e-5);
        CHECK(seen.z < 0);
    }
}

TEST_CASE("a camera's text that cannot be meant is refused with the reason")
{
    const std::pair<const char*, Code> cases[] = {
        {"eye=1,2", Code::usage},
        {"eye=1,2,3,4", Code::usage},
        {"eye=a,b,c", Code::usage},
        {"eye=1,2,nan", Code::not_finite},
        {"eye=1,2,1e999", Code::not_finite},
        {"at=0,0,0;fov=50", Code::usage},
        {"eye=1,2,3;at=1,2,3", Code::out_of_range},
        {"eye=1,2,3;fov=0", Code::out_of_range},
        {"eye=1,2,3;fov=180", Code::out_of_range},
        {"eye=1,2,3;fov=50x", Code::usage},
        {"eye=1,2,3;ortho=-1", Code::out_of_range},
        {"eye=1,2,3;ortho=1;fov=50", Code::usage},
        {"eye=1,2,3;near=0;far=5", Code::out_of_range},
        {"eye=1,2,3;near=5;far=5", Code::out_of_range},
        {"eye=1,2,3;far=5", Code::out_of_range},
        {"eye=1,2,3;top", Code::usage},
    };
    for (const auto& [text, code] : cases) {
        INFO(text);
        CHECK_FALSE(onlyError(choose(text), code).help.empty());
    }
    CHECK(has(onlyError(choose("eye=1,2,3;neer=4"), Code::usage).help, "'near'"));
}
