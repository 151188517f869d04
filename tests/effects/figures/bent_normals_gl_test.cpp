// SPDX-License-Identifier: MIT
// Bent normals, against directions that are known: of open walls, and of the foot of a tall wall.
#include "tests/support/modules.h"
#include "tests/support/picture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;

namespace {

/// Unit vectors in view space, a target of the config.
Image directions(SceneRig& rig, const char* target, const std::string& camera,
                 const char* radius = "radius=0.5")
{
    const GivenConfig config({"geometry/depth_normal", "ssao/gtao", "ssao/bent_normals"},
                             std::string(R"(, "outputs": {"shown": ")") + target + "\"}");
    return rig.draw(config.description({"slices=16", "steps=32", radius}), rig.frame(camera),
                    "shown");
}

glm::vec3 directionAt(const Image& image, int x, int y)
{
    return glm::normalize(
        glm::vec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) * 2.0f - 1.0f);
}

}  // namespace

TEST_CASE("On an open wall the bent normal is the normal, however the wall lies to the camera")
{
    SceneRig rig("plane", {64, 36});
    for (const char* camera :
         {"", "eye=0,0.4,4;at=0,0,-8;fov=60", "eye=5,2,1;at=0,0,0;fov=70",
          "eye=1,2,1;at=0,0,0;up=1,1,0;fov=80", "eye=3,4,5;at=0,0,0;ortho=4"}) {
        const Image bent = directions(rig, "bent_normal", camera);
        const Image normal = directions(rig, "normal", camera);
        INFO(camera);
        float farthest = 0;
        for (int y = 0; y < 36; ++y)
            for (int x = 0; x < 64; ++x)
                if (bent.at(x, y, 3) > 0.5f)
                    farthest = std::max(farthest, glm::distance(directionAt(bent, x, y),
                                                                directionAt(normal, x, y)));
        CHECK(farthest < 0.02f);
    }
}

TEST_CASE("At the foot of a wall the bent normal leans away from it, as far as the light does")
{
    // Of a quarter of the sphere, weighted by the cosine with the floor's normal: the mean
    // direction has pi / 3 along the normal and 2 / 3 away from the wall.
    const float along = glm::pi<float>() / 3, away = 2.0f / 3;
    struct Place {
        const char* text;
        glm::dvec3 at;
        glm::dvec3 bent;
    };
    const Place on_floor = {"0,0,0.1", {0, 0, 0.1}, glm::normalize(glm::dvec3(0, along, away))};
    const Place on_wall = {"0,0.1,0", {0, 0.1, 0}, glm::normalize(glm::dvec3(0, away, along))};
    const std::pair<const char*, glm::dvec3> ups[] = {
        {"0,1,0", {0, 1, 0}}, {"1,0,0", {1, 0, 0}}, {"-1,1,0", {-1, 1, 0}}};
    SceneRig rig("corner", {97, 97});
    for (const Place& place : {on_floor, on_wall})
        for (const auto& [up_text, up] : ups) {
            const std::string camera =
                std::string("eye=0,4,4;at=") + place.text + ";up=" + up_text + ";fov=90";
            const glm::dmat3 view_from_world(glm::lookAt(glm::dvec3(0, 4, 4), place.at, up));
            const glm::vec3 bent =
                directionAt(directions(rig, "bent_normal", camera, "radius=3"), 48, 48);
            INFO(camera);
            CHECK(glm::distance(bent, glm::vec3(view_from_world * place.bent)) < 0.1f);
        }
}
