// SPDX-License-Identifier: MIT
// Stress cases of cameras: projections flipped and turned, a wall walked up to, low eyes.
#include "tools/measure/stress/cases/all.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace crevice {
namespace {

/// What each kind does to the plane of the picture.
const glm::dmat2 kTurns[] = {{1, 0, 0, 1},   {1, 0, 0, -1}, {-1, 0, 0, 1}, {0, 1, -1, 0},
                             {-1, 0, 0, -1}, {0, -1, 1, 0}, {1, 0, 0, 1},  {1, 0, 0, 1}};

/// Square, so that a picture and a turned one have the same size.
StressShot orientation(double value, Extent size)
{
    const int kind = static_cast<int>(value);
    const int side = std::min(size.width, size.height);
    StressShot shot = sceneShot(testView(), {side, side});
    shot.radius = 1;
    shot.block_px = noiseBlock(size);
    shot.turned = kTurns[kind];
    glm::dmat4 turn(shot.turned), mirror(1.0);
    if (kind == 7) {  // depth from 0 to 1, before the viewport halves it again
        turn[2][2] = 0.5;
        turn[3][2] = 0.5;
    }
    if (kind == 6) mirror[2][2] = -1;  // the view looks along +z
    shot.camera.view_from_world = mirror * shot.camera.view_from_world;
    shot.camera.clip_from_view = glm::mat4(turn * glm::dmat4(shot.camera.clip_from_view) * mirror);
    return shot;
}

/// Where a floor and a wall meet, on the x axis, in the middle of the picture.
StressShot wallWalk(double distance, Extent size)
{
    StressView view;
    view.near_distance = distance / 50;
    view.far_distance = distance * 10;
    StressShot shot = sceneShot(view, size, cornerScene());
    // From 30 degrees above the floor, at the edge.
    const glm::dvec3 eye = glm::dvec3(0, 0.5, 0.866) * distance;
    shot.camera.view_from_world = glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0));
    shot.radius = 0.8;
    shot.farthest = distance * 1.5;
    shot.middle = distance;
    return shot;
}

StressShot lowEye(double height, Extent size)
{
    StressView view = testView();
    view.eye.y = height;
    view.near_distance = 0.01;
    StressShot shot = sceneShot(view, size);
    shot.radius = 1;
    return shot;
}

}  // namespace

std::vector<StressCase> cameraCases()
{
    using E = Expectation;
    return {
        {"orientation",
         "The test scene through flipped, turned and left-handed projections: means over blocks.",
         "",
         kinds({"ordinary", "flipped in y", "flipped in x", "turned by 90", "turned by 180",
                "turned by 270", "left-handed", "from 0 to 1 in depth"}),
         0, E::same, orientation, "where the projection is {}"},
        {"wall_walk", "An inner corner from ever nearer, radius 0.8: it gets darker.",
         "scene units", steps({4, 2, 1, 0.5, 0.25, 0.12, 0.03}), 0, E::darkens, wallWalk,
         kTallRadius},
        {"low_eye", "The test scene from ever closer to its floor, under a radius of 1.",
         "scene units", steps({1, 0.3, 0.1, 0.03, 0.01, 0.001}), 0, E::sound, lowEye,
         "where the camera is lower than {} radii over the floor"},
    };
}

}  // namespace crevice
