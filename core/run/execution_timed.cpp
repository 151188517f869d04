// SPDX-License-Identifier: MIT
// Running a prepared plan with a time for each pass.
#include "core/run/execution.h"
#include "core/run/frame_clock.h"

namespace crevice {

Result<FrameTimes> Execution::runTimed(const Frame& frame)
{
    FrameTimes times;
    times.pass_ms.resize(plan_.passes.size());
    timers_.forget();
    device_.finish();
    const FrameClock clock(device_.caps().software);
    const double start = clock.now();
    if (Status status = device_.beginFrame(); !status) return status.diagnostics();
    cache_.clear();
    begin(frame);
    clearNewHistories();
    int slot = 0;
    for (const PreparedView& view : views_) {
        setView(frame, view);
        for (std::size_t i = 0; i < times.pass_ms.size(); ++i)
            times.method = timePass(view.passes[i], slot++, view.camera, clock, times.pass_ms[i]);
    }
    const Status status = end(frame);
    if (!status) return status.diagnostics();
    device_.finish();
    times.total_ms = clock.now() - start;
    if (times.method == TimingMethod::gpu_timer) readTimers(times);
    return {std::move(times), status.diagnostics()};
}

bool Execution::setTiming(bool on)
{
    const bool able = device_.caps().timers && runCount() <= kMaxFrameTimers;
    timers_.start(on && able ? runCount() : 0, plan_.passes.size());
    return able;
}

/// The method is the same for every pass: the device's answer is, and so is the count of passes.
/// Adds to `clock_ms`; with the GPU's timer that stays as it is.
TimingMethod Execution::timePass(const PreparedPass& pass, int slot, const CameraMatrices& camera,
                                 const FrameClock& clock, double& clock_ms)
{
    if (runCount() <= kMaxTimers && device_.beginTimer(slot)) {
        runPass(pass, camera);
        device_.endTimer();
        return TimingMethod::gpu_timer;
    }
    const double begin = clock.now();
    runPass(pass, camera);
    device_.finish();
    clock_ms += clock.now() - begin;
    return clock.method();
}

void Execution::readTimers(FrameTimes& times)
{
    times.total_ms = 0;
    for (int slot = 0; slot < runCount(); ++slot) {
        const double ms = device_.readTimer(slot);
        double& pass_ms = times.pass_ms[slot % times.pass_ms.size()];
        pass_ms = ms < 0 || pass_ms < 0 ? -1 : pass_ms + ms;
        times.total_ms = ms < 0 || times.total_ms < 0 ? -1 : times.total_ms + ms;
    }
}

}  // namespace crevice
