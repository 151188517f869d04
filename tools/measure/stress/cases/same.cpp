// SPDX-License-Identifier: MIT
// Stress cases that show the test scene in other ways, none of which may change the picture; and of
// cameras: projections flipped and turned, a wall walked up to, low eyes.
#include "tools/measure/stress/cases/all.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace crevice {
namespace {

constexpr double kSameRadius = 1;  // scene units

StressShot testShot(const StressView& view, Extent size, Scene scene = testScene())
{
    StressShot shot = sceneShot(view, size, std::move(scene));
    shot.radius = kSameRadius;
    return shot;
}

StressShot sceneUnits(double scale, Extent size)
{
    StressView view = testView();
    view.eye *= scale;
    view.near_distance *= scale;
    view.far_distance *= scale;
    StressShot shot =
        testShot(view, size, placed(testScene(), glm::scale(glm::dmat4(1.0), glm::dvec3(scale))));
    shot.radius = kSameRadius * scale;
    shot.farthest = testShot(testView(), size).farthest * scale;
    return shot;
}

StressShot sceneOffset(double radii, Extent size)
{
    const glm::dvec3 offset = glm::dvec3(radii, 0, -radii) * kSameRadius;
    StressView view = testView();
    view.eye += offset;
    StressShot shot =
        testShot(view, size, placed(testScene(), glm::translate(glm::dmat4(1.0), offset)));
    shot.farthest = testShot(testView(), size).farthest;
    return shot;
}

StressShot sceneNearFar(double power, Extent size)
{
    StressView view = nearFarView(power);
    view.eye = testView().eye;
    return testShot(view, size);
}

StressShot sceneProjection(double kind, Extent size)
{
    StressView view = testView();
    view.reversed = kind == 1 || kind == 3;
    view.infinite = kind >= 2;
    return testShot(view, size);
}

StressShot sceneShift(double pixels, Extent size)
{
    StressView view = testView();
    view.shift_px = static_cast<int>(pixels) * size.width / 256;
    StressShot shot = testShot(view, size);
    shot.moved.x = -2.0 * view.shift_px / size.width;
    shot.border_px = size.width / 8;
    shot.block_px = noiseBlock(size);
    return shot;
}

StressShot sceneMirrored(double kind, Extent size)
{
    StressShot shot = testShot(testView(), size);
    shot.block_px = noiseBlock(size);
    if (kind == 0) return shot;
    shot.scene = placed(shot.scene, glm::scale(glm::dmat4(1.0), {-1, 1, 1}));
    if (kind == 2) shot.scene = baked(shot.scene);
    shot.turned = {-1, 0, 0, 1};
    return shot;
}

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

std::vector<StressCase> sameCases()
{
    using E = Expectation;
    const StressCondition shifted = "where the frustum is shifted further than {} pixels of 256";
    return {
        {"units", "The test scene in other units, by its model matrices.", "units", decades(-6, 6),
         6, E::same, sceneUnits, "where all lengths are more than {} times as large",
         "where all lengths are less than {} times as large"},
        {"offset", "The test scene far from the origin, by its model matrices.", "radii",
         steps({0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7}), 0, E::same, sceneOffset,
         "more than {} radii from the origin"},
        {"near_far", "The test scene between ever farther near and far planes.", "near:far",
         nearFarSteps(), 1, E::same, sceneNearFar, kWideNearFar, kNarrowNearFar},
        {"projection", "The test scene through other projections of depth.", "",
         kinds({"ordinary", "reversed", "infinite", "reversed and infinite"}), 0, E::same,
         sceneProjection, "where the depth projection is {}"},
        {"off_centre",
         "The test scene through an off-centre frustum: means over the radius that both show.",
         "pixels of 256", steps({-64, -32, 0, 32, 64}), 2, E::same, sceneShift, shifted, shifted},
        {"mirrored", "The test scene mirrored; noise is not, so means over the radius count.", "",
         kinds({"ordinary", "by a matrix", "in the vertices"}), 0, E::same, sceneMirrored,
         "where the scene is mirrored {}"},
    };
}

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
