// SPDX-License-Identifier: MIT
// What passes take: on the GPU, read once it is known, some frames later; or by a clock.
#pragma once

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

/// A ring of kTimedFrames frames in flight. A frame that finds its place in the ring still unread,
/// because the GPU is further behind than that, is not measured.
class PassTimers {
public:
    /// Measures so many runs of passes a frame from now on, those of `passes` passes for each view
    /// in turn; 0 measures nothing. What was measured before is forgotten. Where the device has no
    /// timers, or too few, `clock` measures, with a wait after each run; it must outlive this.
    void start(int runs, std::size_t passes, const FrameClock* clock = nullptr);

    /// Forgets frames in flight: another has used the device's timers.
    void forget();

    /// Takes the results that are there. Outside of frames.
    void collect(Device& device);

    void beginFrame();

    /// Waits for what the last frame took; by a clock its total is left 0. Outside of frames.
    const FrameTimes& wait(Device& device);

    const FrameTimes* latest() const { return any_ ? &latest_ : nullptr; }

    /// Measures a run from here to endRun.
    void beginRun(Device& device, std::size_t run);
    void endRun(Device& device, std::size_t run);

private:
    struct TimedFrame {
        std::vector<char> ran;  // by run
        bool in_flight = false;
    };

    std::size_t last() const { return (next_ + kTimedFrames - 1) % kTimedFrames; }
    int slotOf(std::size_t frame, std::size_t run) const;
    bool isReady(Device& device, std::size_t frame) const;
    void read(Device& device, std::size_t frame);

    int runs_ = 0;
    const FrameClock* clock_ = nullptr;
    TimedFrame frames_[kTimedFrames];
    std::size_t next_ = 0;  // frame to be measured: the oldest one
    bool measures_ = false;
    bool running_ = false;  // a timer of the device
    double begin_ms_ = 0;   // of a run, by the clock
    FrameTimes latest_;
    bool any_ = false;
};

}  // namespace crevice
