// SPDX-License-Identifier: MIT
// What passes of earlier frames took on the GPU, read once it is known: nothing waits.
#pragma once

#include <crevice/frame.h>

#include <cstddef>
#include <vector>

namespace crevice {

/// A ring of kTimedFrames frames in flight. A frame that finds its place in the ring still unread,
/// because the GPU is further behind than that, is not measured.
class PassTimers {
public:
    /// Measures so many runs of passes a frame from now on, those of `passes` passes for each view
    /// in turn; 0 measures nothing. What was measured before is forgotten.
    void start(int runs, std::size_t passes);

    /// Forgets frames in flight: another has used the device's timers.
    void forget();

    /// Takes the results that are there. Outside of frames.
    void collect(Device& device);

    void beginFrame();

    const FrameTimes* latest() const { return any_ ? &latest_ : nullptr; }

    /// Measures a run while it lives.
    class Scope {
    public:
        Scope(PassTimers& timers, Device& device, std::size_t run);
        ~Scope();
        Scope(const Scope&) = delete;

    private:
        Device& device_;
        bool running_;
    };

private:
    struct TimedFrame {
        std::vector<char> ran;  // by run
        bool in_flight = false;
    };

    int slotOf(std::size_t frame, std::size_t run) const;
    bool isReady(Device& device, std::size_t frame) const;
    void read(Device& device, std::size_t frame);

    int runs_ = 0;
    TimedFrame frames_[kTimedFrames];
    std::size_t next_ = 0;  // frame to be measured: the oldest one
    bool measures_ = false;
    FrameTimes latest_ = {TimingMethod::gpu_timer, {}, 0};
    bool any_ = false;
};

}  // namespace crevice
