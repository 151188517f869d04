// SPDX-License-Identifier: MIT
// Far taps read coarser copies of depth, each texel of which is one of depth.
#include "tests/support/modules.h"
#include "tests/support/picture.h"

#include <cmath>

using namespace crevice;

namespace {

/// Two steps of 24 bits, by which a value may move when it is stored once more.
constexpr float kStep = 2e-7f;

/// Whether `depth` has that value somewhere in the block of 2^level texels on a side.
bool holds(const Image& depth, int level, int x, int y, float value)
{
    for (int v = y << level; v < (y + 1) << level; ++v)
        for (int u = x << level; u < (x + 1) << level; ++u)
            if (std::abs(depth.at(u, v) - value) < kStep) return true;
    return false;
}

}  // namespace

TEST_CASE("A texel of a level is one of the texels of depth that it stands for")
{
    SceneRig rig("room", {97, 53});
    const Description description =
        GivenConfig({"gtao", "geometry/depth_levels"}).description({"guard_band=1"});
    const auto target = [&](const char* name) {
        return rig.draw(showing(description, name), rig.frame(), "shown");
    };
    const Image levels = target("depth_levels"), depth = target("depth");
    REQUIRE(levels.extent == depth.extent);
    const Extent corners[] = {{0, 0}, {48, 0}, {48, 13}, {48, 13 + 6}};
    for (int level = 1; level <= 4; ++level) {
        INFO(level);
        for (int y = 0; y < 53 >> level; ++y)
            for (int x = 0; x < 97 >> level; ++x) {
                const Extent corner = corners[level - 1];
                CHECK(holds(depth, level, x, y, levels.at(corner.width + x, corner.height + y)));
            }
    }
}
