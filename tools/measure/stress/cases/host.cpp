// SPDX-License-Identifier: MIT
// Stress cases over other geometry: stored positions, and a host's depth and normals of other
// projections and with invalid values in them.
#include "tools/measure/stress/cases/all.h"
#include "tools/measure/stress/geometry.h"

#include "core/base/numbers.h"

#include <glm/matrix.hpp>

#include <cmath>
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

/// What a host does to its depth, drawn through `clip_from_view`: each becomes `stored(distance
/// along the view axis, whether something was drawn)`.
template <class Stored>
auto storedBy(const glm::dmat4& clip_from_view, const Stored& stored)
{
    return [view_from_clip = glm::inverse(clip_from_view), stored](Image& depth, Image&) {
        for (float& value : depth.pixels) {
            const glm::dvec4 view = view_from_clip * glm::dvec4(0, 0, value * 2.0 - 1.0, 1);
            value = static_cast<float>(stored(-view.z / view.w, value < 1));
        }
    };
}

StressShot hostProjection(double kind, Extent size)
{
    StressShot shot = hostShot(size);
    StressView view = testView();
    view.reversed = kind == 1 || kind == 3;
    view.infinite = kind == 2 || kind == 3;
    shot.camera = cameraOf(view, size);
    const glm::dmat4 to = shot.camera.clip_from_view;
    const double background = view.reversed ? 0 : 1;
    if (kind > 0)
        shot.host =
            storedBy(shot.host_camera.clip_from_view, [to, background](double z, bool seen) {
                const glm::dvec4 clip = to * glm::dvec4(0, 0, -z, 1);
                return seen ? clip.z / clip.w * 0.5 + 0.5 : background;
            });
    return shot;
}

/// 1 for linear depth, else the power of ten to which logarithmic depth reaches; for a camera with
/// reversed depth.
StressShot hostEncoding(double kind, Extent size)
{
    if (kind == 0) return hostShot(size);
    StressShot shot = hostProjection(3, size);
    const glm::dmat4 drawn = shot.host_camera.clip_from_view;
    if (kind == 1) {
        shot.geometry = kHostLinearGeometry;
        shot.host = storedBy(drawn, [](double z, bool seen) { return seen ? z : 0; });
        return shot;
    }
    const double far = std::pow(10, kind);
    shot.geometry = kHostLogGeometry;
    shot.settings = {"log_far=" + fixed(far, 6)};
    shot.host = storedBy(
        drawn, [far](double z, bool seen) { return seen ? std::log1p(z) / std::log1p(far) : 1; });
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
    const StressCondition stored = {"where the host's depth is {}"};
    return {
        {"inputs",
         "The same config over depth, over stored positions and over linear depth.",
         "",
         kinds({kDepthGeometry, kPositionGeometry, kLinearGeometry}),
         0,
         E::same,
         inputs,
         {"over {}"}},
        {"host_projection", "A host's depth of other projections.", "",
         kinds({"ordinary", "reversed", "infinite", "reversed and infinite"}), 0, E::same,
         hostProjection, stored},
        {"host_encoding",
         "A host's linear depth, and its logarithmic depth to ever farther.",
         "",
         {{0, "straight"},
          {1, "linear"},
          {2, "logarithmic to 1e2"},
          {4, "logarithmic to 1e4"},
          {7, "logarithmic to 1e7"}},
         0,
         E::same,
         hostEncoding,
         stored},
        {"host_depth",
         "Three pixels of invalid values in a host's depth: nothing changes beyond the radius.",
         "",
         kinds({"ordinary", "NaN", "infinity", "-infinity", "-1", "0", "1", "2", "1e30", "-1e30"}),
         0,
         E::same,
         hostDepth,
         {"with {} in the host's depth"},
         {},
         kSamePixel},
        {"host_normal",
         "Three pixels of invalid values in a host's normals.",
         "",
         kinds({"ordinary", "NaN", "infinity", "no length", "-1e30", "1e30"}),
         0,
         E::same,
         hostNormal,
         {"with {} in the host's normals"},
         {},
         kSamePixel},
    };
}

}  // namespace crevice
