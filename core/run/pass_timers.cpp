// SPDX-License-Identifier: MIT
#include "core/run/pass_timers.h"

#include <algorithm>

namespace crevice {

void PassTimers::start(int runs, std::size_t passes)
{
    runs_ = runs;
    forget();
    any_ = false;
    latest_.pass_ms.assign(passes, 0.0);
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
    frames_[frame].in_flight = false;
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

PassTimers::Scope::Scope(PassTimers& timers, Device& device, std::size_t run)
    : device_(device),
      running_(false)
{
    if (!timers.measures_) return;
    const std::size_t frame = (timers.next_ + kTimedFrames - 1) % kTimedFrames;
    running_ = device.beginTimer(timers.slotOf(frame, run));
    timers.frames_[frame].ran[run] = running_;
}

PassTimers::Scope::~Scope()
{
    if (running_) device_.endTimer();
}

}  // namespace crevice
