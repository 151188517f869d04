// SPDX-License-Identifier: MIT
// What is measured next, and how sure an answer is, of made-up figures; and a config's neighbours.
#include "tools/measure/bench/race.h"

#include "core/base/text.h"
#include "tests/support/catch.h"
#include "tests/support/need.h"
#include "tools/measure/taps.h"

#include <crevice/shipped.h>

using namespace crevice;

namespace {

using Kind = ChoiceLimit::Kind;

Standing measured(double ms, double error)
{
    return {rangeOf(ms, 0.03 * ms), rangeOf(ms, 0.03 * ms), rangeOf(error, 0.03 * error), true};
}

/// By a small picture: a third to three times that.
Standing guessed(double ms, double error)
{
    const auto range = [](double value) { return scaled({value, value, value}, factorOf({})); };
    return {range(ms), range(ms), range(error)};
}

struct Row {
    std::vector<Standing> standings;
    ChoiceLimits limits;
    int next;  ///< -1: none.
    bool whole_front = false;
};

const Row kRows[] = {
    {{guessed(1, .1), guessed(2, .05)}, {{Kind::time_ms, 3}}, 1},   // the most promising first
    {{guessed(1, .1), guessed(20, .05)}, {{Kind::time_ms, 3}}, 0},  // too slow whatever it be
    {{guessed(20, .05)}, {{Kind::time_ms, 3}}, -1},
    {{measured(2, .05), guessed(2, .1)}, {{Kind::time_ms, 3}}, 1},  // may be at .033
    {{measured(2, .05), guessed(2, .16)}, {{Kind::time_ms, 3}}, -1},
    {{measured(4, .01), guessed(2, .16)}, {{Kind::time_ms, 3}}, 1},  // who is beyond leads nothing
    {{measured(2, .05), guessed(5, .1)}, {{Kind::error, .06}}, 1},   // may take 1.7
    {{measured(2, .05), guessed(7, .1)}, {{Kind::error, .06}}, -1},
    {{measured(2, .05), guessed(1, .2)}, {{Kind::error, .06}}, -1},
    {{measured(2, .05), guessed(1, .1)}, {{Kind::error, .06}, {Kind::ratio, .3}}, -1},
    {{guessed(1, .1)}, {{Kind::error, .06}, {Kind::ratio, .5}}, 0},
    {{measured(2, .05), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, -1},
    {{measured(2, .05), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, 1, true},  // .033 at 9 ms
    {{measured(2, .03), guessed(9, .1)}, {{Kind::time_ms, 2.5}}, -1, true},
    {{}, {{Kind::time_ms, 2.5}}, -1, true},
};

/// Of that rmse at a hundred pixels, all alike; or one that is `more` wrong at every second one.
SparseError errorOf(double rmse, double more = 0)
{
    SparseError error;
    error.rmse = rmse;
    for (int i = 0; i < 100; ++i)
        error.squares.push_back(static_cast<float>(rmse * rmse + (i % 2 ? more : -more)));
    return error;
}

}  // namespace

TEST_CASE("what could win even at the best of its ranges is measured, the most promising first")
{
    for (const Row& row : kRows) {
        INFO(&row - kRows);
        const auto next = nextOf(row.standings, row.limits, row.whole_front);
        CHECK((next ? static_cast<int>(*next) : -1) == row.next);
    }
    const std::vector<Standing> two = {measured(2, .05), measured(3, .04)};
    CHECK(leaderOf(two, {{Kind::time_ms, 4}}) == std::size_t(1));
    CHECK(leaderOf({measured(2, .042), two[1]}, {{Kind::time_ms, 4}}) == std::size_t(0));
    CHECK(leaderOf(two, {{Kind::time_ms, 4}, {Kind::error, .06}}) == std::size_t(0));
    CHECK(!leaderOf(two, {{Kind::time_ms, 4}, {Kind::error, .01}}));
    CHECK(nearestOf(two, {{Kind::time_ms, 1}, {Kind::error, .01}}) == 1);
    CHECK(nearestOf(two, {{Kind::time_ms, .1}, {Kind::error, .01}}) == 0);
}

TEST_CASE("ranges narrow with what small pictures turned out to be")
{
    CHECK(factorOf({}).low < 0.5);
    const Range known = factorOf({0.8, 1.0, 1.1});
    CHECK(known.value == 1.0);
    CHECK(known.low > 0.5);
    CHECK(known.low < 0.8);
    CHECK(known.high > 1.1);
    CHECK(known.high < 2.0);
}

TEST_CASE("an answer is sure where nothing else within the limits is better by over 5 %")
{
    const ChoiceLimits time = {{Kind::time_ms, 3}}, error = {{Kind::error, .06}};
    const SparseError best = errorOf(.040, .0001), near = errorOf(.0385, .0001),
                      far = errorOf(.03, .0001);
    std::vector<Standing> all = {measured(2, .04), measured(2.1, .0385)};
    all[0].pixels = &best;
    all[1].pixels = &near;
    CHECK(sureness(all, 0, time) > 0.9);  // as good: 4 % less wrong
    all[1] = measured(2.1, .03);
    all[1].pixels = &far;
    CHECK(sureness(all, 0, time) < 0.1);
    CHECK(sureness(all, 1, time) > 0.9);
    all[1].ms = rangeOf(4, .1);  // beyond the limit
    CHECK(sureness(all, 0, time) > 0.9);
    all[0].ms = rangeOf(3, .1);  // is it within?
    CHECK(sureness(all, 0, time) == Approx(0.5).margin(0.01));
    CHECK(sureness({measured(2, .05), measured(1.96, .05)}, 0, error) > 0.9);
    CHECK(sureness({measured(2, .05), measured(1.5, .05)}, 0, error) < 0.1);
}

TEST_CASE("neighbours move what costs time, and the rest of the settings stay")
{
    const Node document = need(loadConfig(shippedSources(), {"high"}));
    const auto settings = neighbourSettings(need(decode(document, shippedSources())));
    for (const char* setting : {"steps=15", "steps=6", "slices=3", "slices=1", "ao_scale=0.56",
                                "ao_scale=0.36", "guard_band=1.1", "back_faces=false"})
        CHECK(contains(settings, setting));
    for (const std::string& setting : settings) {
        INFO(setting);
        CHECK(!startsWith(setting, "radius="));
        CHECK(!startsWith(setting, "max_gap="));
        CHECK(loadConfig(shippedSources(), {"high", {}, {setting}}).ok());
    }
    CHECK(withSetting({"steps=2", "radius=1"}, "steps=3") ==
          std::vector<std::string>{"radius=1", "steps=3"});
    const auto swaps = filterSwaps(shippedSources(), {"hemisphere_box"});
    CHECK(contains(swaps, "filter/box=filter/median"));
    CHECK(filterSwaps(shippedSources(), {"mobile"}).empty());
}
