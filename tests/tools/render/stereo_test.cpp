// SPDX-License-Identifier: MIT
// Two eyes in the place of a camera: where they stand, what they see, and their pictures together.
#include "tools/render/stereo.h"

#include "tests/support/need.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kExtent = {200, 100};

SceneCamera turnedCamera()
{
    SceneCamera camera;
    camera.view_from_world =
        glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0));
    camera.shift = {0.25, -0.125};
    camera.near_distance = 0.1;
    camera.far_distance = 100.0;
    return camera;
}

/// Where a point that `camera` has in its view space is seen in an eye's picture, [-1, 1].
glm::dvec2 seen(const SceneCamera& eye, const SceneCamera& camera, const glm::dvec3& point)
{
    const glm::dmat4 clip_from_view = clipFromView(eye, kExtent, {});
    const glm::dvec4 clip = clip_from_view * glm::dmat4(eye.view_from_world) *
                            glm::inverse(glm::dmat4(camera.view_from_world)) *
                            glm::dvec4(point, 1.0);
    return glm::dvec2(clip) / clip.w;
}

std::vector<SceneCamera> eyesOf(const SceneCamera& camera, double separation, double convergence)
{
    return need(eyeCameras(camera, {separation, convergence}, 2.0));
}

}  // namespace

TEST_CASE("The left eye stands to the left of the camera and the right one to the right")
{
    const SceneCamera camera = turnedCamera();
    const auto eyes = eyesOf(camera, 0.5, 0.0);
    REQUIRE(eyes.size() == 2);
    for (int i = 0; i < 2; ++i) {
        const glm::mat4 view_from_eye =
            camera.view_from_world * glm::inverse(eyes[i].view_from_world);
        const glm::vec3 offset = view_from_eye[3];
        CHECK(glm::length(offset - glm::vec3(i == 0 ? -0.25 : 0.25, 0, 0)) < 1e-5);
    }
    const auto one = eyesOf(camera, 0.0, 0.0);  // no separation
    REQUIRE(one.size() == 1);
    CHECK(one[0].view_from_world == camera.view_from_world);
    CHECK(one[0].shift == camera.shift);
}

TEST_CASE("Both eyes see the point of convergence where the camera sees it, all at one height")
{
    const SceneCamera camera = turnedCamera();
    const auto eyes = eyesOf(camera, 0.5, 4.0);
    for (const double distance : {1.0, 4.0, 30.0}) {
        const glm::dvec3 point(0.4, -0.3, -distance);
        const glm::dvec2 left = seen(eyes[0], camera, point);
        const glm::dvec2 right = seen(eyes[1], camera, point);
        CHECK(left.y == Approx(right.y).margin(1e-5));
        if (distance < 4.0) CHECK(left.x > right.x + 0.01);
        if (distance > 4.0) CHECK(left.x < right.x - 0.01);
        if (distance != 4.0) continue;
        CHECK(left.x == Approx(right.x).margin(1e-5));
        CHECK(left.x == Approx(seen(camera, camera, point).x).margin(1e-5));
    }
    const auto parallel = eyesOf(camera, 0.5, 0.0);  // these converge nowhere
    CHECK(parallel[0].shift == camera.shift);
    const glm::dvec3 far_away(1e5, 2e4, -1e6);
    CHECK(seen(parallel[0], camera, far_away).x ==
          Approx(seen(parallel[1], camera, far_away).x).margin(1e-5));
}

TEST_CASE("An orthographic camera has no second eye")
{
    SceneCamera camera;
    camera.orthographic = true;
    const auto eyes = eyeCameras(camera, {0.5, 0.0}, 2.0);
    REQUIRE_FALSE(eyes.ok());
    CHECK(eyes.diagnostics().front().code == Code::usage);
    CHECK(eyeCameras(camera, {}, 2.0).ok());
}

TEST_CASE("Pictures side by side keep their rows and channels")
{
    Image left({2, 2}, 3), right({2, 2}, 3);
    for (std::size_t i = 0; i < left.pixels.size(); ++i) {
        left.pixels[i] = float(i);
        right.pixels[i] = 100.0f + float(i);
    }
    const Image both = sideBySide(left, right);
    CHECK(both.extent == Extent{4, 2});
    REQUIRE(both.channels == 3);
    CHECK(both.pixels == std::vector<float>{0, 1, 2, 3, 4,  5,  100, 101, 102, 103, 104, 105,
                                            6, 7, 8, 9, 10, 11, 106, 107, 108, 109, 110, 111});
}
