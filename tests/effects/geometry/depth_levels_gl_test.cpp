// SPDX-License-Identifier: MIT
// Far taps read coarser copies of depth, each texel of which is one of depth.
#include "tests/support/modules.h"
#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <cmath>

using namespace crevice;

namespace {

using Overrides = std::vector<std::string>;

/// A config with the levels added to it.
Description withLevels(const std::string& config, const Overrides& overrides, const char* more = "")
{
    return GivenConfig({config, "geometry/depth_levels"}, more).description(overrides);
}

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
    const auto target = [&](const char* name) {
        const std::string shown = std::string(R"(, "outputs": {"shown": ")") + name + "\"}";
        return rig.draw(withLevels("gtao", {"guard_band=1"}, shown.c_str()), rig.frame(), "shown");
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

TEST_CASE("Levels change little, the nearer they begin the more, and nothing beyond every tap")
{
    SceneRig rig("room");
    for (const char* config : {"sao", "learnopengl", "ogldev45"}) {
        INFO(config);
        const Image without = rig.draw(descriptionOf({config}, {"radius=1"}), rig.frame());
        const auto change = [&](const char* near_taps) {
            const Image image = rig.draw(withLevels(config, {"radius=1", near_taps}), rig.frame());
            CHECK(allVisibility(image));
            return meanChange(image, without);
        };
        CHECK(change("near_taps=10000") == 0.0);
        const double far = change("near_taps=16"), near = change("near_taps=1");
        CHECK(near > 0.0);
        CHECK(near >= far);
        CHECK(far < 0.005);
    }
}

TEST_CASE("Levels of tiny and odd views, and of views with a guard band, draw visibility")
{
    SceneRig rig("room");
    for (const Extent extent : {Extent{1, 1}, Extent{5, 3}, Extent{17, 31}, Extent{33, 16}})
        for (const char* guard : {"guard_band=1", "guard_band=1.37"}) {
            rig.extent = extent;
            const Overrides overrides = {"radius=4", "near_taps=1", guard};
            CHECK(allVisibility(rig.draw(withLevels("sao", overrides), rig.frame())));
        }
}
