// SPDX-License-Identifier: MIT
// Far taps read coarser copies of depth, each texel of which is one of depth.
#include "tests/support/picture.h"

#include <crevice/shipped.h>

#include <cmath>

using namespace crevice;

namespace {

/// A config with the levels added to it.
Image drawn(const std::string& config, PictureRequest request)
{
    MemorySources mine;
    mine.add("configs/levels.json",
             R"({"format": 1, "extends": [")" + config + R"(", "geometry/depth_levels"]})");
    const LayeredSources sources({&mine, &shippedSources()});
    request.config = "levels";
    request.sources = &sources;
    return picture(request);
}

Image withoutLevels(const std::string& config, PictureRequest request)
{
    request.config = config;
    return picture(request);
}

PictureRequest room(std::vector<std::string> overrides)
{
    PictureRequest request;
    request.scene = "room";
    request.overrides = std::move(overrides);
    return request;
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
    PictureRequest request = room({"guard_band=1"});
    request.extent = {97, 53};
    request.target = "depth_levels";
    const Image levels = drawn("gtao", request);
    request.target = "depth";
    const Image depth = withoutLevels("gtao", request);
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
    for (const char* config : {"sao", "learnopengl", "ogldev45"}) {
        INFO(config);
        const Image without = withoutLevels(config, room({"radius=1"}));
        const auto change = [&](const char* near_taps) {
            const Image image = drawn(config, room({"radius=1", near_taps}));
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
    for (const Extent extent : {Extent{1, 1}, Extent{5, 3}, Extent{17, 31}, Extent{33, 16}})
        for (const char* guard : {"guard_band=1", "guard_band=1.37"}) {
            PictureRequest request = room({"radius=4", "near_taps=1", guard});
            request.extent = extent;
            CHECK(allVisibility(drawn("sao", request)));
        }
}
