// SPDX-License-Identifier: MIT
// Measuring one sample of a bench on a device: its error, its time, its pictures.
//
// What is timed are the passes that the sample's output needs, by default `ao`. The config and
// `learnopengl` with the same radius take turns (tools/measure/bench/times.h) until the ratio is
// known to a few per cent. The cost of a config is the sum over its passes other than draw
// passes: for `ao`, what it adds to a host that has a G-buffer. Beside it stands the cost with the
// geometry that the occlusion alone needs.
#pragma once

#include "tools/measure/bench/run.h"
#include "tools/measure/bench/times.h"
#include "tools/render/host_textures.h"

namespace crevice {

struct MeasureOptions {
    int rays = 256;  ///< Per pixel of the ground truth.
    /// Timed turns, at least; up to four times as many where ratios do not settle.
    int repeats = 7;
    bool motion = false;       ///< Measure what changes along camera paths.
    std::string cache_folder;  ///< For ground truths; empty for none.
    std::string out_folder;    ///< Pictures go to its pictures/; empty for none.
    std::function<bool()> interrupted = [] { return false; };
    std::function<void(double done)> tracing = {};  ///< How far a ground truth is.
};

/// The device, the plan and the sources must outlive it.
class BenchMeter {
public:
    BenchMeter(Device& device, const BenchPlan& plan, const SourceSet& sources,
               MeasureOptions options);
    ~BenchMeter();

    /// The task's sample with its figures. What the next task shares with this one is kept.
    ///
    /// Errors: CV7007 for pictures; whatever keeps the ground truth or the config from being drawn,
    /// CV4003 for an occlusion that is not a number somewhere.
    Result<BenchSample> measure(const BenchTask& task);

private:
    struct Setting;

    Status enter(const BenchTask& task);
    Status measureErrors(const Image& ao, BenchSample& sample);
    void measureMotion(const BenchTask& task, Drawn& drawn, BenchSample& sample);
    Status measureTimes(const BenchTask& task, Drawn& drawn, BenchSample& sample);
    Status writePictures(const BenchTask& task, const Image& ao, BenchSample& sample);

    Device& device_;
    const BenchPlan& plan_;
    const SourceSet& sources_;
    const MeasureOptions options_;
    std::unique_ptr<Setting> setting_;
};

}  // namespace crevice
