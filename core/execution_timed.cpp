// SPDX-License-Identifier: MIT
// Running a prepared plan with a time for each pass.
#include "core/execution.h"

#include <chrono>

namespace crevice {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

Result<FrameTimes> Execution::runTimed(const Frame& frame)
{
    FrameTimes times;
    times.pass_ms.resize(passes_.size());
    device_.finish();
    const Clock::time_point start = Clock::now();
    const CameraMatrices camera = begin(frame);
    for (std::size_t i = 0; i < passes_.size(); ++i)
        times.method = timePass(i, frame, camera, times.pass_ms[i]);
    if (Status status = end(camera); !status) return status.diagnostics();
    device_.finish();
    times.total_ms = millisecondsSince(start);
    if (times.method == TimingMethod::gpu_timer) readTimers(times);
    return times;
}

/// The method is the same for every pass: the device's answer is, and so is the count of passes.
/// With the GPU's timer, `clock_ms` stays as it is.
TimingMethod Execution::timePass(std::size_t index, const Frame& frame,
                                 const CameraMatrices& camera, double& clock_ms)
{
    if (passes_.size() <= kMaxTimers && device_.beginTimer(static_cast<int>(index))) {
        runPass(passes_[index], frame, camera);
        device_.endTimer();
        return TimingMethod::gpu_timer;
    }
    const Clock::time_point begin = Clock::now();
    runPass(passes_[index], frame, camera);
    device_.finish();
    clock_ms = millisecondsSince(begin);
    return TimingMethod::wall_clock;
}

void Execution::readTimers(FrameTimes& times)
{
    times.total_ms = 0;
    bool valid = true;
    for (std::size_t i = 0; i < times.pass_ms.size(); ++i) {
        times.pass_ms[i] = device_.readTimer(static_cast<int>(i));
        times.total_ms += times.pass_ms[i];
        valid = valid && times.pass_ms[i] >= 0;
    }
    if (!valid) times.total_ms = -1;
}

}  // namespace crevice
