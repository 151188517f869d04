// SPDX-License-Identifier: MIT
// Stress cases over other geometry: stored positions, linear depth, and a host's depth and normals
// with invalid values in them.
#include "tools/measure/stress/cases/all.h"
#include "tools/measure/stress/scenes.h"

#include <limits>

namespace crevice {
namespace {

constexpr double kHostRadius = 0.5;  // scene units; small, so that much lies beyond it

/// Far enough for the radius at the nearest object in view, and for any filter.
constexpr int kReach = 60;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

StressShot hostShot(Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    shot.radius = kHostRadius;
    shot.geometry = kHostGeometry;
    shot.host_camera = shot.camera;
    shot.host = [](Image&, Image&) {};
    return shot;
}

/// Pixels over the picture, away from its borders.
std::vector<glm::ivec2> scattered(Extent size)
{
    std::vector<glm::ivec2> all;
    for (const glm::ivec2 fifth : {glm::ivec2(1, 1), glm::ivec2(3, 2), glm::ivec2(2, 4)})
        all.push_back({fifth.x * size.width / 5, fifth.y * size.height / 5});
    return all;
}

const double kNaN = std::numeric_limits<double>::quiet_NaN();
const double kDepths[] = {0, kNaN, kInfinity, -kInfinity, -1, 0, 1, 2, 1e30, -1e30};
const double kNormals[] = {0, kNaN, kInfinity, 0.5, -1e30, 1e30};

void spoil(Image& image, const std::vector<glm::ivec2>& places, double value)
{
    for (const glm::ivec2 at : places)
        for (int channel = 0; channel < image.channels; ++channel)
            image.at(at.x, at.y, channel) = static_cast<float>(value);
}

StressShot spoiledShot(double kind, double value, Extent size, bool normals)
{
    StressShot shot = hostShot(size);
    if (kind == 0) return shot;
    shot.spoiled = scattered(size);
    shot.reach_px = kReach * size.height / 144;
    shot.host = [places = shot.spoiled, value, normals](Image& depth, Image& normal) {
        spoil(normals ? normal : depth, places, value);
    };
    return shot;
}

StressShot hostDepth(double kind, Extent size)
{
    return spoiledShot(kind, kDepths[static_cast<int>(kind)], size, false);
}

StressShot hostNormal(double kind, Extent size)
{
    return spoiledShot(kind, kNormals[static_cast<int>(kind)], size, true);
}

StressShot inputs(double kind, Extent size)
{
    StressShot shot = sceneShot(testView(), size);
    const char* const geometry[] = {kDepthGeometry, kPositionGeometry, kLinearGeometry};
    shot.geometry = geometry[static_cast<int>(kind)];
    return shot;
}

}  // namespace

std::vector<StressCase> hostCases()
{
    using E = Expectation;
    return {
        {"inputs", "The same config over depth, over stored positions and over linear depth.", "",
         kinds({kDepthGeometry, kPositionGeometry, kLinearGeometry}), 0, E::same, inputs,
         "over {}"},
        {"host_depth",
         "Three pixels of invalid values in a host's depth: nothing changes beyond the radius.", "",
         kinds({"ordinary", "NaN", "infinity", "-infinity", "-1", "0", "1", "2", "1e30", "-1e30"}),
         0, E::same, hostDepth, "with {} in the host's depth", "", kSamePixel},
        {"host_normal", "Three pixels of invalid values in a host's normals.", "",
         kinds({"ordinary", "NaN", "infinity", "no length", "-1e30", "1e30"}), 0, E::same,
         hostNormal, "with {} in the host's normals", "", kSamePixel},
    };
}

}  // namespace crevice
