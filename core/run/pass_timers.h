// SPDX-License-Identifier: MIT
// What passes take: on the GPU, read once it is known, some frames later; or by a clock.
#pragma once

#include "core/gpu/owned.h"

#include <crevice/frame.h>

namespace crevice {

/// Take its time, draw, wait with Device::finish, and take it again.
///
/// On a software renderer it counts the processor time of the process, all threads together: there
/// the drawing is done by threads of this process, and what else the machine does hardly counts.
/// Elsewhere, and on platforms that do not tell the processor time, it is a steady wall clock.
class FrameClock {
public:
    /// `software` as DeviceCaps has it.
    explicit FrameClock(bool software);

    TimingMethod method() const { return method_; }

    /// Milliseconds since some moment that stays the same.
    double now() const;

private:
    TimingMethod method_;
};

/// Frames whose timers are kept apart, so that those of earlier ones can be read without a wait.
constexpr int kTimedFrames = 4;

/// A ring of kTimedFrames frames in flight, with timers of its own. A frame that finds its place in
/// the ring still unread, because the GPU is further behind than that, is not measured.
class PassTimers {
public:
    /// The device must outlive this.
    explicit PassTimers(Device& device) : device_(device) {}

    /// Measures so many runs of passes a frame from now on, those of `passes` passes for each view
    /// in turn; 0 measures nothing. What was measured before is forgotten. A device without timers
    /// requires a `clock`, which measures with a wait after each run; it must outlive this.
    /// Outside of frames.
    void start(std::size_t runs, std::size_t passes, const FrameClock* clock = nullptr);

    /// Takes the results that are there. Outside of frames.
    void collect();

    void beginFrame();

    /// Waits for what the last frame took; by a clock its total is left 0. Outside of frames.
    const FrameTimes& wait();

    const FrameTimes* latest() const { return any_ ? &latest_ : nullptr; }

    /// Measures a run from here to endRun.
    void beginRun(std::size_t run);
    void endRun(std::size_t run);

private:
    struct TimedRun {
        Owned<TimerId> timer;
        bool ran = false;  // in the frame
    };

    struct TimedFrame {
        std::vector<TimedRun> runs;
        bool in_flight = false;
    };

    TimedFrame& last() { return frames_[(next_ + kTimedFrames - 1) % kTimedFrames]; }
    bool isReady(const TimedFrame& frame) const;
    void read(TimedFrame& frame);

    Device& device_;
    const FrameClock* clock_ = nullptr;  // where the device has no timers
    TimedFrame frames_[kTimedFrames];
    std::size_t next_ = 0;  // frame to be measured: the oldest one
    bool measures_ = false;
    double begin_ms_ = 0;  // of a run, by the clock
    FrameTimes latest_;
    bool any_ = false;
};

}  // namespace crevice
