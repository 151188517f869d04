// SPDX-License-Identifier: MIT
// Cameras: framing a scene, choosing one by name, reading one from text.
#include "tools/camera_framing.h"

#include "tests/catch.h"

#include <algorithm>
#include <cmath>

using namespace crevice;

namespace {

Bounds box(const glm::dvec3& low, const glm::dvec3& high)
{
    Bounds bounds;
    bounds.add(low);
    bounds.add(high);
    return bounds;
}

const Bounds kBox = box({-1, 0, -2}, {3, 2, 5});

Scene sceneWithCameras()
{
    Scene scene;
    scene.name = "hall";
    scene.cameras.resize(2);
    scene.cameras[0].name = "door";
    scene.cameras[1].name = "balcony";
    return scene;
}

Result<SceneCamera> choose(const std::string& text)
{
    return chooseCamera(sceneWithCameras(), kBox, text, 1.5);
}

glm::dvec3 eyeOf(const SceneCamera& camera)
{
    return glm::inverse(glm::dmat4(camera.view_from_world))[3];
}

// The largest clip coordinate, as a part of w, of any corner of the bounds.
double largestClip(const SceneCamera& camera, const Bounds& bounds, Extent extent)
{
    const glm::dmat4 clip_from_world =
        glm::dmat4(clipFromView(camera, extent, bounds)) * glm::dmat4(camera.view_from_world);
    double largest = 0;
    for (int index = 0; index < 8; ++index) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(bounds.corner(index), 1);
        if (clip.w <= 0) return 1e9;
        largest = std::max({largest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w),
                            std::abs(clip.z / clip.w)});
    }
    return largest;
}

}  // namespace

TEST_CASE("a framed scene is in the picture whole and fills it, at any shape of either")
{
    const Bounds shapes[] = {kBox, box({-1, -1, -1}, {1, 1, 1}), box({0, 0, 0}, {100, 0.1, 0.1}),
                             box({0, 0, 0}, {0.1, 50, 0.1}), box({5, 5, 5}, {5.001, 5.002, 5}),
                             box({-1e6, 0, -1e6}, {1e6, 1e5, 1e6})};
    for (const Bounds& bounds : shapes) {
        for (const Extent extent : {Extent{960, 540}, {100, 100}, {100, 900}, {2000, 100}}) {
            const double aspect = static_cast<double>(extent.width) / extent.height;
            const double largest = largestClip(frameScene(bounds, aspect), bounds, extent);
            CHECK(largest < 1.0);
            CHECK(largest > 0.9);
        }
    }
}

TEST_CASE("framing looks down from above")
{
    const SceneCamera camera = frameScene(kBox, 1.5);
    CHECK(eyeOf(camera).y > kBox.center().y);
    CHECK(glm::dmat4(camera.view_from_world)[1].y > 0.5);
}

TEST_CASE("a scene that is one point or nothing can be framed")
{
    for (const Bounds& bounds : {Bounds(), box({2, 2, 2}, {2, 2, 2})}) {
        const SceneCamera camera = frameScene(bounds, 1.5);
        CHECK(std::isfinite(eyeOf(camera).x));
        CHECK(glm::determinant(camera.view_from_world) == Approx(1));
    }
}

TEST_CASE("without a wish the scene's first camera is taken, or the scene is framed")
{
    CHECK(choose("")->name == "door");
    CHECK(chooseCamera(Scene(), kBox, "", 1.5)->name == "framing");
}

TEST_CASE("a camera is chosen by its name")
{
    CHECK(choose("balcony")->name == "balcony");
}

TEST_CASE("a camera that the scene does not have suggests its nearest")
{
    const auto camera = choose("balcon");
    REQUIRE_FALSE(camera.ok());
    CHECK(camera.diagnostics()[0].code == Code::camera_missing);
    CHECK(camera.diagnostics()[0].help.find("'balcony'") != std::string::npos);
}

TEST_CASE("a camera is read from text")
{
    const auto camera = choose("eye=4,2,6;at=0,1,0;up=0,0,1;fov=35;near=0.5;far=20");
    INFO(toText(camera.diagnostics()));
    REQUIRE(camera.ok());
    CHECK(glm::length(eyeOf(*camera) - glm::dvec3(4, 2, 6)) < 1e-5);
    const glm::dvec4 at = glm::dmat4(camera->view_from_world) * glm::dvec4(0, 1, 0, 1);
    CHECK(at.x == Approx(0).margin(1e-5));
    CHECK(at.y == Approx(0).margin(1e-5));
    CHECK(at.z < 0);
    CHECK(camera->fov_y_rad == Approx(35 * 3.14159265 / 180));
    CHECK(camera->near_distance == 0.5);
    CHECK(camera->far_distance == 20);
    CHECK_FALSE(camera->orthographic);
}

TEST_CASE("a camera's text needs no more than an eye")
{
    const auto camera = choose("eye=9,9,9");
    REQUIRE(camera.ok());
    const glm::dvec4 center = glm::dmat4(camera->view_from_world) * glm::dvec4(kBox.center(), 1);
    CHECK(center.x == Approx(0).margin(1e-5));
    CHECK(center.y == Approx(0).margin(1e-5));
    CHECK(camera->far_distance == 0);
}

TEST_CASE("an orthographic camera is as high as it says")
{
    const auto camera = choose("eye=0,0,9;at=0,0,0;ortho=3");
    REQUIRE(camera.ok());
    CHECK(camera->orthographic);
    const glm::mat4 clip = clipFromView(*camera, {200, 100}, kBox);
    CHECK((clip * glm::vec4(0, 1.5f, -5, 1)).y == Approx(1));
    CHECK((clip * glm::vec4(3, 0, -5, 1)).x == Approx(1));
}

TEST_CASE("a camera that looks straight down has an up of its own")
{
    for (const char* text : {"eye=0,9,0;at=0,0,0", "eye=0,0,9;at=0,0,0;up=0,0,1",
                             "eye=1,2,3;at=0,0,0;up=0,0,0"}) {
        const auto camera = choose(text);
        REQUIRE(camera.ok());
        CHECK(glm::determinant(camera->view_from_world) == Approx(1));
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
        const auto camera = choose(text);
        REQUIRE_FALSE(camera.ok());
        REQUIRE(camera.diagnostics().size() == 1);
        CHECK(camera.diagnostics()[0].code == code);
        CHECK_FALSE(camera.diagnostics()[0].help.empty());
    }
}

TEST_CASE("a misspelt part of a camera suggests the right one")
{
    const auto camera = choose("eye=1,2,3;neer=4");
    REQUIRE_FALSE(camera.ok());
    CHECK(camera.diagnostics()[0].help.find("'near'") != std::string::npos);
}
