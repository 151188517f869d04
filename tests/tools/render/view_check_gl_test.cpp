// SPDX-License-Identifier: MIT
// The distance of what a frame shows.
#include "tools/render/view_check.h"

#include "tests/support/gl_fixture.h"
#include "tests/support/need.h"
#include "tools/render/scene_upload.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {96, 54};

/// A square of side `size`, in a scene that is seen from the origin.
Scene square(float size, const glm::dmat4& world_from_model)
{
    Scene scene;
    const float s = size / 2;
    MeshDesc mesh;
    mesh.vertices = {{{-s, -s, 0}}, {{s, -s, 0}}, {{s, s, 0}}, {{-s, s, 0}}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes = {mesh};
    scene.materials.emplace_back();
    scene.instances = {{0, world_from_model, 0}};
    return scene;
}

Scene facing(double distance)
{
    return square(100, glm::translate(glm::dmat4(1), {0, 0, -distance}));
}

std::optional<double> distanceOf(GlFixture& gl, const Scene& scene)
{
    const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    const Frame frame = makeFrame(uploaded, SceneCamera(), kExtent);
    return medianDistance(need(drawDepth(*gl.device, frame, kExtent)), frame.camera);
}

}  // namespace

TEST_CASE("The median distance is that of what most of the view shows")
{
    GlFixture gl;
    CHECK(*distanceOf(gl, facing(5)) == Approx(5).epsilon(0.01));
    Scene two = facing(9);
    two.instances.push_back({0, glm::translate(glm::dmat4(1), {51, 0, -3}), 0});
    CHECK(*distanceOf(gl, two) == Approx(9).epsilon(0.01));
    two.instances.back().world_from_model = glm::translate(glm::dmat4(1), {0, 0, -3});
    CHECK(*distanceOf(gl, two) == Approx(3).epsilon(0.01));
    CHECK_FALSE(distanceOf(gl, facing(-5)));
}

TEST_CASE("A floor that the camera stands on is seen though it passes behind the eye")
{
    GlFixture gl;
    const glm::dmat4 below = glm::translate(glm::dmat4(1), {0, -1, 0});
    const auto distance =
        distanceOf(gl, square(100, glm::rotate(below, glm::radians(-90.0), {1, 0, 0})));
    REQUIRE(distance);
    CHECK(*distance > 1);
    CHECK(*distance < 50);
}
