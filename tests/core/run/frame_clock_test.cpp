// SPDX-License-Identifier: MIT
// What the clock of a software renderer counts, and what it does not.
#include "core/run/pass_timers.h"

#include "tests/support/catch.h"

#include <chrono>
#include <thread>

using namespace crevice;

namespace {

constexpr double kSpell = 40.0;  // milliseconds
constexpr double kMostPatience = 20e3;

}  // namespace

TEST_CASE("A software renderer's clock stands still while the process waits")
{
    const FrameClock processor(true), wall(false);
    REQUIRE(processor.method() == TimingMethod::processor_time);
    REQUIRE(wall.method() == TimingMethod::wall_clock);
    const double begin = processor.now(), wall_begin = wall.now();
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(kSpell));
    CHECK(processor.now() - begin < kSpell / 2);
    CHECK(wall.now() - wall_begin >= kSpell * 0.99);
}

TEST_CASE("A software renderer's clock counts the work of other threads")
{
    const FrameClock processor(true), wall(false);
    const double begin = processor.now(), wall_begin = wall.now();
    std::thread worker([&] {
        while (processor.now() - begin < kSpell && wall.now() - wall_begin < kMostPatience)
            continue;
    });
    worker.join();
    CHECK(processor.now() - begin >= kSpell);
}
