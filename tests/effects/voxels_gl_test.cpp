// SPDX-License-Identifier: MIT
// What the screen does not show occludes through voxels: a wall whose occlusion of a floor is
// known.
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"
#include "tools/render/scene/mesh_shapes.h"

#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kExtent = {256, 144};

/// A floor at y = 0 and a wall that begins at `x`, higher than a radius of 1; with `lid` under
/// something that is beyond the radius.
Scene floorAndWall(float x, bool lid)
{
    Scene scene;
    scene.meshes = {makeBox({-4, -0.2f, -4}, {4, 0, 4}), makeBox({x, 0, -4}, {x + 0.2f, 1.5f, 4})};
    if (lid) scene.meshes.push_back(makeBox({x - 0.2f, 2, -4}, {x + 0.6f, 2.1f, 4}));
    scene.instances.resize(scene.meshes.size());
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        scene.meshes[i].label = "box";
        scene.instances[i].mesh = static_cast<int>(i);
    }
    scene.materials.resize(1);
    return scene;
}

/// Visibility of a floor that far from a wall: all but a segment of the unit disc.
double openBeside(double apart)
{
    return 1 - (std::acos(apart) - apart * std::sqrt(1 - apart * apart)) / std::acos(-1.0);
}

/// At x on the floor, of what a camera above sees of it.
double seenAt(const Image& ao, double x)
{
    const int column = static_cast<int>((x / 1.28 + 0.5) * ao.extent.width);
    double sum = 0;
    for (int y = ao.extent.height / 4; y < 3 * ao.extent.height / 4; ++y)
        for (int i = column - 4; i < column + 4; ++i) sum += ao.at(i, y);
    return sum / (4 * ao.extent.height);
}

}  // namespace

TEST_CASE("A wall off the screen, or hidden from it, darkens a floor as far as it should")
{
    struct Case {
        const char* what;
        float wall;
        bool lid;
        double at[2];
    };
    for (const Case& each : {Case{"off the screen", 0.8f, false, {0.3, 0.55}},
                             Case{"under a lid", 0.4f, true, {-0.2, 0.1}}}) {
        SceneRig rig(floorAndWall(each.wall, each.lid), kExtent);
        const Frame frame = rig.frame("eye=0,4,0;at=0,0,0;up=0,0,-1;ortho=0.72");
        for (const char* const config : {"balanced", "balanced_far", "vxao"}) {
            const Image ao = rig.draw(descriptionOf({config}, {"radius=1"}), frame);
            for (const double x : each.at) {
                INFO(config << ", a wall " << each.what << " from " << x);
                const double off = seenAt(ao, x) - openBeside(each.wall - x);
                if (std::string(config) == "balanced")
                    CHECK(std::abs(off) > 0.06);
                else
                    CHECK(off == Approx(0).margin(0.03));
            }
        }
    }
}
