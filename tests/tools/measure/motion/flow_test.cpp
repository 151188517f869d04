// SPDX-License-Identifier: MIT
// Which surface points two frames share, and where.
#include "tests/tools/measure/motion/planted.h"

#include "tests/support/catch.h"

#include <cmath>

using namespace crevice;

namespace {

/// A box that ends at x = 20 and has moved to begin at `to`, with the camera where it was.
Image boxFlow(double from, double to)
{
    return flowTo(plantedSurfaces(0, 0, from), plantedSurfaces(0, 0, to), plantedCamera(0, 0));
}

bool counts(const Image& flow, int x) { return !std::isnan(flow.at(x, 12)); }

}  // namespace

TEST_CASE("a point is found where the next frame sees it, up to the last pixel that it has")
{
    for (const auto& [right, up] : {std::pair(0.0, 0.0), {2.25, 0.5}}) {
        const Image flow =
            flowTo(plantedSurfaces(0, 0), plantedSurfaces(right, up), plantedCamera(right, up));
        for (int y = 0; y < kPlanted.height; ++y)
            for (int x = 0; x < kPlanted.width; ++x) {
                INFO(x << ", " << y);
                const bool inside = x >= std::ceil(right) && y >= std::ceil(up);  // four texels
                CHECK(std::isnan(flow.at(x, y, 0)) == !inside);
                if (!inside) continue;
                CHECK(flow.at(x, y, 0) == Approx(x - right));
                CHECK(flow.at(x, y, 1) == Approx(y - up));
            }
    }
}

TEST_CASE("what is hidden in the next frame does not count, nor does what was uncovered")
{
    const Image hidden = boxFlow(1e9, 20), uncovered = boxFlow(20, 1e9);
    for (int x = 0; x < kPlanted.width; ++x) {
        INFO(x);
        CHECK(counts(hidden, x) == (x < 20));
        CHECK(counts(uncovered, x) == (x < 20));
    }
}

TEST_CASE("a crease counts, and the background does not")
{
    SurfaceMap crease = plantedSurfaces(0, 0);
    for (SurfacePoint& point : crease.points)
        if (point.position.x > 20) {
            point.position.z = point.position.x - 20;
            point.normal = glm::normalize(glm::dvec3(-1, 0, 1));
        }
    SurfaceMap moved = crease;
    for (SurfacePoint& point : moved.points) {
        point.position.x += 0.25;
        point.position.z = std::max(point.position.x - 20, 0.0);
    }
    const Image flow = flowTo(crease, moved, plantedCamera(0.25, 0));
    for (int x = 1; x < kPlanted.width; ++x) CHECK(counts(flow, x));

    SurfaceMap open = plantedSurfaces(0, 0);
    open.points[12 * kPlanted.width + 7].seen = false;
    CHECK_FALSE(counts(flowTo(open, plantedSurfaces(0, 0), plantedCamera(0, 0)), 7));
    CHECK_FALSE(counts(flowTo(plantedSurfaces(0, 0), open, plantedCamera(0, 0)), 7));
}

TEST_CASE("what a box hid and shows now is uncovered, and what lay off the picture is not")
{
    const Image mask =
        uncoveredSince(plantedSurfaces(3, 0, 20), plantedCamera(3, 0), plantedSurfaces(0, 0, 30));
    for (int x = 0; x < kPlanted.width; ++x) {
        INFO(x);
        CHECK(mask.at(x, 12) == (x >= 20 && x < 30 ? 1.0f : 0.0f));
    }
}
