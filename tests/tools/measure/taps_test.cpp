// SPDX-License-Identifier: MIT
// Depth taps a pixel of configs that count them and of configs that march in slices.
#include "tools/measure/taps.h"

#include "tests/support/catch.h"

using namespace crevice;

namespace {

ParamDesc whole(const char* name, int value, int max)
{
    ParamDesc param;
    param.name = name;
    param.value[0] = static_cast<float>(value);
    param.min = 1;
    param.max = max;
    return param;
}

Description marching(int slices, int steps)
{
    Description description;
    description.params = {whole("slices", slices, 16), whole("steps", steps, 32)};
    return description;
}

Description counting(int samples)
{
    Description description;
    description.params = {whole("samples", samples, 128)};
    return description;
}

}  // namespace

TEST_CASE("taps a pixel are counted by samples or by slices both ways")
{
    CHECK(samplesOf(counting(64)) == 64);
    CHECK(samplesOf(marching(3, 3)) == 18);
    CHECK(samplesOf({}) == 0);
}

TEST_CASE(
    "another count is one override, or shared between slices and steps in the config's own ratio")
{
    CHECK(overridesFor(counting(64), 16) == std::vector<std::string>{"samples=16"});
    CHECK(overridesFor(counting(64), 129).empty());
    const auto split = [](const Description& description, int count) {
        return overridesFor(description, count);
    };
    CHECK(split(marching(2, 4), 16) == std::vector<std::string>{"slices=2", "steps=4"});
    CHECK(split(marching(2, 4), 64) == std::vector<std::string>{"slices=4", "steps=8"});
    CHECK(split(marching(3, 3), 8) == std::vector<std::string>{"slices=2", "steps=2"});
    CHECK(split(marching(1, 8), 8) == std::vector<std::string>{"slices=1", "steps=4"});
    CHECK(split(marching(2, 4), 7).empty());       // not the same on both ways
    CHECK(split(marching(2, 4), 2 * 37).empty());  // 37 fits neither range
}
