// SPDX-License-Identifier: MIT
#include "core/config/values.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace crevice;

TEST_CASE("A param takes its own bounds, though no float is 0.01")
{
    ParamDesc power;
    power.name = "power";
    power.min = 0.01;
    power.max = 0.7;
    REQUIRE(double{0.01f} < power.min);
    const auto takes = [&power](float value) { return checkValue(power, &value, 1).ok(); };
    CHECK(takes(0.01f));
    CHECK(takes(0.7f));
    CHECK_FALSE(takes(std::nextafter(0.01f, 0.0f)));
    CHECK_FALSE(takes(std::nextafter(0.7f, 1.0f)));
}

TEST_CASE("A length is in scene units, a share of the scene or pixels of the view, as they are")
{
    ParamDesc radius;
    radius.name = "radius";
    radius.max = 100;
    radius.semantic = ParamSemantic::length;
    SceneTraits traits;
    traits.scale = {20, 8};
    traits.camera.zoom = 2;
    const auto length = [&](const char* text) {
        return takeLength(text, radius.value) ? sceneUnits(radius, traits, 400)[0] : -1;
    };
    CHECK(length("5%") == 1);
    CHECK(length("40px") == 40 * 8 / 400.0f);
    CHECK(length("0%") == 0);
    CHECK(length("1000%") == 100);  // as far as it may be
    radius.value = {0, 5, 0, 8};    // at most 8 % of the view's height, which is 8 there
    CHECK(sceneUnits(radius, traits, 400)[0] == 0.64f);
    traits.orthographic = true;
    CHECK(length("40px") == 40 / 400.0f);
    for (const char* wrong : {"", "%", "abc%", "-5%", "nan%", "5em", "5 %", "5", "1e99px"})
        CHECK(length(wrong) == -1);
    traits = SceneTraits();
    CHECK(std::isnan(length("5%")));
    CHECK(std::isnan(length("40px")));
}
