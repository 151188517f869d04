// SPDX-License-Identifier: MIT
// The distance of what a frame shows.
#include "tools/render/view_diagnosis.h"

#include "tests/support/gl_fixture.h"
#include "tests/support/need.h"
#include "tools/render/scene/mesh_shapes.h"
#include "tools/render/scene_upload.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

constexpr Extent kExtent = {96, 54};

/// A large square, in a scene that is seen from the origin.
Scene square(const glm::dmat4& world_from_model)
{
    Scene scene;
    scene.meshes = {makeQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0})};
    scene.materials.emplace_back();
    scene.instances = {{0, world_from_model, 0}};
    return scene;
}

glm::dmat4 at(double x, double y, double z) { return glm::translate(glm::dmat4(1), {x, y, z}); }

std::optional<double> distanceOf(GlFixture& gl, const Scene& scene)
{
    const UploadedScene uploaded = need(UploadedScene::upload(*gl.device, scene));
    const Frame frame = makeFrame(uploaded, SceneCamera(), kExtent);
    return medianDistance(need(drawDepth(*gl.device, frame, kExtent)), frame.camera);
}

}  // namespace

TEST_CASE("The median distance is that of what most of the view shows, also behind the eye")
{
    GlFixture gl;
    CHECK(*distanceOf(gl, square(at(0, 0, -5))) == Approx(5).epsilon(0.01));
    Scene two = square(at(0, 0, -9));
    two.instances.push_back({0, at(51, 0, -3), 0});
    CHECK(*distanceOf(gl, two) == Approx(9).epsilon(0.01));
    two.instances.back().world_from_model = at(0, 0, -3);
    CHECK(*distanceOf(gl, two) == Approx(3).epsilon(0.01));
    CHECK_FALSE(distanceOf(gl, square(at(0, 0, 5))));
    // A floor that the camera stands on.
    const auto floor =
        distanceOf(gl, square(glm::rotate(at(0, -1, 0), glm::radians(-90.0), {1, 0, 0})));
    REQUIRE(floor);
    CHECK(*floor > 1);
    CHECK(*floor < 50);
}
