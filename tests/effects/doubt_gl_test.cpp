// SPDX-License-Identifier: MIT
// What ssao/doubt expects of the error: where there is none, that it is one number and one picture,
// and that it rises with what it is told by. How right it is, tools/scripts/fit_doubt.py measures.
#include <crevice/effect.h>
#include <crevice/governor.h>

#include "tests/support/picture.h"
#include "tests/support/shipped_subjects.h"

#include <cmath>

using namespace crevice;

namespace {

constexpr Extent kExtent = {256, 144};

/// A preset's estimate of a built-in scene.
double estimateOf(SceneRig& rig, const std::string& config, std::vector<std::string> overrides = {})
{
    overrides.push_back("radius=0.5");
    return rig.draw(descriptionOf({config}, overrides), rig.frame(), kErrorEstimate).pixels[0];
}

}  // namespace

TEST_CASE("A picture's doubt is that of its pixels, none in the background")
{
    for (const char* const config : {"mobile", "balanced", "gtao"}) {
        INFO(config);
        SceneRig rig("spheres", kExtent);
        const Description description = descriptionOf({config}, {"radius=0.5"});
        const Image doubt = rig.draw(description, rig.frame(), "doubt");
        const Image depth = rig.draw(showing(description, "depth"), rig.frame(), "shown");
        REQUIRE(doubt.extent == kExtent);
        CHECK(allVisibility(doubt));
        const int band = (depth.extent.width - kExtent.width) / 2;
        const int rows = (depth.extent.height - kExtent.height) / 2;
        double squares = 0, surfaces = 0;
        for (int y = 0; y < kExtent.height; ++y)
            for (int x = 0; x < kExtent.width; ++x) {
                const double value = doubt.at(x, y);
                const bool drawn = depth.at(x + band, y + rows) < 1;
                if (!drawn) CHECK(value < 0.1);  // a tile may reach over the edge
                squares += value * value;
                surfaces += drawn;
            }
        const double estimate = estimateOf(rig, config);
        CHECK(estimate > 0.005);
        CHECK(estimate == Approx(std::sqrt(squares / surfaces)).epsilon(0.2));
    }
}

TEST_CASE("There is no doubt of a plane in the open, and less of more samples")
{
    SceneRig plane("plane", kExtent), room("room", kExtent);
    for (const char* const config : {"mobile", "balanced", "high", "gtao"}) {
        INFO(config);
        CHECK(estimateOf(plane, config) < 0.005);
        CHECK(estimateOf(room, config, {"slices=4", "steps=16"}) < estimateOf(room, config));
        CHECK(estimateOf(room, config, {"intensity=0"}) == 0);
        const double once = estimateOf(room, config);
        std::vector<std::string> fourfold;
        for (const ParamDesc& param : descriptionOf({config}).params)
            if (param.name.rfind("doubt_", 0) == 0)
                fourfold.push_back(param.name + "=" + std::to_string(4 * param.value[0]));
        CHECK(fourfold.size() == 3);
        CHECK(estimateOf(room, config, fourfold) == Approx(2 * once).epsilon(0.05));
    }
}

TEST_CASE("An application learns the error that is expected of its picture, without a wait")
{
    SceneRig rig("room", kExtent);
    Effect effect = need(Effect::create(*rig.device, "balanced", kExtent, {"ao", kErrorEstimate}));
    need(effect.setParam("radius", 0.5f));
    effect.frame() = rig.frame();
    CHECK_FALSE(effect.value(kErrorEstimate));
    CHECK_FALSE(effect.value("doubt"));
    for (int i = 0; i < 8; ++i) {
        need(effect.render());
        rig.device->finish();
    }
    REQUIRE(effect.value(kErrorEstimate));
    CHECK(*effect.value(kErrorEstimate) == Approx(estimateOf(rig, "balanced")).epsilon(1e-3));
    CHECK_FALSE(effect.value("doubt"));  // not drawn

    need(effect.govern(
        {{{"mobile"}, {"radius=0.5"}, 1, 0.08}, {{"balanced"}, {"radius=0.5"}, 2, 0.05}}, {100}));
    CHECK(effect.governor()->report().estimate == 0);
    for (int i = 0; i < 8; ++i) need(effect.render());
    CHECK(effect.governor()->report().estimate ==
          Approx(estimateOf(rig, "balanced")).epsilon(1e-3));
}
