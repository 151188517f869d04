// SPDX-License-Identifier: MIT
// Processor time or wall clock.
#include "core/run/frame_clock.h"

#include <chrono>
#include <ctime>
#include <optional>

namespace crevice {
namespace {

std::optional<double> processTime()
{
#ifdef CLOCK_PROCESS_CPUTIME_ID
    timespec time = {};
    if (clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time) == 0)
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
#endif
    return std::nullopt;
}

double wallTime()
{
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(since).count();
}

}  // namespace

FrameClock::FrameClock(bool software)
    : method_(software && processTime() ? TimingMethod::processor_time : TimingMethod::wall_clock)
{
}

double FrameClock::now() const
{
    return method_ == TimingMethod::processor_time ? processTime().value_or(0.0) : wallTime();
}

}  // namespace crevice
