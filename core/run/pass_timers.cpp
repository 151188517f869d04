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

void PassTimers::start(int runs, std::size_t passes, const FrameClock* clock)
{
    runs_ = runs;
    clock_ = clock;
    forget();
    any_ = false;
    latest_ = {clock ? clock->method() : TimingMethod::gpu_timer, std::vector<double>(passes), 0,
               0};
    for (TimedFrame& frame : frames_) frame.ran.assign(runs, 0);
}

void PassTimers::forget()
{
    for (TimedFrame& frame : frames_) frame.in_flight = false;
    measures_ = false;
}

int PassTimers::slotOf(std::size_t frame, std::size_t run) const
{
    return static_cast<int>(frame) * kMaxFrameTimers + static_cast<int>(run);
}

bool PassTimers::isReady(Device& device, std::size_t frame) const
{
    for (int run = 0; run < runs_; ++run)
        if (frames_[frame].ran[run] && !device.timerReady(slotOf(frame, run))) return false;
    return true;
}

void PassTimers::read(Device& device, std::size_t frame)
{
    std::fill(latest_.pass_ms.begin(), latest_.pass_ms.end(), 0.0);
    latest_.total_ms = 0;
    for (int run = 0; run < runs_; ++run) {
        if (!frames_[frame].ran[run]) continue;
        const double ms = device.readTimer(slotOf(frame, run));
        for (double* sum : {&latest_.pass_ms[run % latest_.pass_ms.size()], &latest_.total_ms})
            *sum = ms < 0 || *sum < 0 ? -1 : *sum + ms;
    }
    any_ = true;
    ++latest_.count;
    frames_[frame].in_flight = false;
}

const FrameTimes& PassTimers::wait(Device& device)
{
    if (latest_.method == TimingMethod::gpu_timer) read(device, last());
    return latest_;
}

void PassTimers::collect(Device& device)
{
    measures_ = false;
    for (std::size_t i = 0; i < kTimedFrames && runs_ > 0; ++i) {
        const std::size_t frame = (next_ + i) % kTimedFrames;  // the oldest first
        if (!frames_[frame].in_flight) continue;
        if (!isReady(device, frame)) return;
        read(device, frame);
    }
}

void PassTimers::beginFrame()
{
    TimedFrame& frame = frames_[next_];
    measures_ = runs_ > 0 && !frame.in_flight;
    if (!measures_) return;
    std::fill(frame.ran.begin(), frame.ran.end(), 0);
    frame.in_flight = true;
    next_ = (next_ + 1) % kTimedFrames;
}

void PassTimers::beginRun(Device& device, std::size_t run)
{
    running_ = measures_ && runs_ <= kMaxTimers && device.beginTimer(slotOf(last(), run));
    if (!measures_) return;
    frames_[last()].ran[run] = running_;
    if (running_)
        latest_.method = TimingMethod::gpu_timer;
    else if (clock_)
        begin_ms_ = clock_->now();
}

void PassTimers::endRun(Device& device, std::size_t run)
{
    if (running_) return device.endTimer();
    if (!measures_ || !clock_) return;
    device.finish();
    latest_.pass_ms[run % latest_.pass_ms.size()] += clock_->now() - begin_ms_;
}

}  // namespace crevice
