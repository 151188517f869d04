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
