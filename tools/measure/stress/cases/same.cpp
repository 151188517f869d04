// SPDX-License-Identifier: MIT
// Stress cases that show the test scene in other ways, none of which may change the picture.
#include "tools/measure/stress/cases/all.h"

#include <glm/gtc/matrix_transform.hpp>

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

}  // namespace crevice
