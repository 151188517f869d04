// SPDX-License-Identifier: MIT
#include "core/run/pass_timers.h"

#include <algorithm>
#include <chrono>
#include <ctime>

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

}  // namespace

FrameClock::FrameClock(bool software)
    : method_(software && processTime() ? TimingMethod::processor_time : TimingMethod::wall_clock)
{
}

double FrameClock::now() const
{
    if (method_ == TimingMethod::processor_time) return processTime().value_or(0.0);
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(since).count();
}

void PassTimers::start(std::size_t runs, std::size_t passes, const FrameClock* clock)
{
    clock_ = device_.caps().timers ? nullptr : clock;
    any_ = measures_ = false;
    latest_ = {clock_ ? clock_->method() : TimingMethod::gpu_timer, std::vector<double>(passes), 0,
               0};
    for (TimedFrame& frame : frames_) {
        frame.in_flight = false;
        frame.runs.resize(runs);
        for (TimedRun& run : frame.runs)
            if (!run.timer.id()) run.timer = {device_, device_.createTimer()};
    }
}

bool PassTimers::isReady(const TimedFrame& frame) const
{
    return std::all_of(frame.runs.begin(), frame.runs.end(), [this](const TimedRun& run) {
        return !run.ran || device_.timerReady(run.timer.id());
    });
}

void PassTimers::read(TimedFrame& frame)
{
    std::fill(latest_.pass_ms.begin(), latest_.pass_ms.end(), 0.0);
    latest_.total_ms = 0;
    for (std::size_t run = 0; run < frame.runs.size(); ++run) {
        if (!frame.runs[run].ran) continue;
        const double ms = device_.readTimer(frame.runs[run].timer.id());
        for (double* sum : {&latest_.pass_ms[run % latest_.pass_ms.size()], &latest_.total_ms})
            *sum = ms < 0 || *sum < 0 ? -1 : *sum + ms;
    }
    any_ = true;
    ++latest_.count;
    frame.in_flight = false;
}

const FrameTimes& PassTimers::wait()
{
    if (latest_.method == TimingMethod::gpu_timer) read(last());
    return latest_;
}

void PassTimers::collect()
{
    measures_ = false;
    for (std::size_t i = 0; i < kTimedFrames; ++i) {
        TimedFrame& frame = frames_[(next_ + i) % kTimedFrames];  // the oldest first
        if (!frame.in_flight) continue;
        if (!isReady(frame)) return;
        read(frame);
    }
}

void PassTimers::beginFrame()
{
    TimedFrame& frame = frames_[next_];
    measures_ = !frame.runs.empty() && !frame.in_flight;
    if (!measures_) return;
    for (TimedRun& run : frame.runs) run.ran = false;
    frame.in_flight = true;
    next_ = (next_ + 1) % kTimedFrames;
}

void PassTimers::beginRun(std::size_t run)
{
    if (!measures_) return;
    TimedRun& timed = last().runs[run];
    timed.ran = true;
    if (clock_)
        begin_ms_ = clock_->now();
    else
        device_.beginTimer(timed.timer.id());
}

void PassTimers::endRun(std::size_t run)
{
    if (!measures_) return;
    if (!clock_) return device_.endTimer();
    device_.finish();
    latest_.pass_ms[run % latest_.pass_ms.size()] += clock_->now() - begin_ms_;
}

}  // namespace crevice
