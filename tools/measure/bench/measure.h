// SPDX-License-Identifier: MIT
// Measuring one sample of a bench on a device: its error, its time, its pictures.
//
// What is timed are the passes that the sample's output needs, by default `ao`. The config and
// `learnopengl` with the same radius take turns (see tools/measure/bench/times.cpp) until the ratio
// is known to a few per cent. The cost of a config is the sum over its passes other than draw
// passes: for `ao`, what it adds to a host that has a G-buffer. Beside it stands the cost with the
// geometry that the occlusion alone needs.
#pragma once

#include "tools/measure/bench/run.h"
#include "tools/measure/bench/sample.h"
#include "tools/render/host_textures.h"

#include <crevice/renderer.h>

namespace crevice {

/// Draws a frame until its times are valid: a GPU's timer may be disturbed now and then.
/// Errors: those of Renderer::renderTimed; CV6005 when the timer is disturbed time after time.
Result<FrameTimes> timeFrame(Renderer& renderer, const Frame& frame);

/// The sum over the passes that are no draw passes: what a host with a G-buffer pays for the
/// occlusion.
double occlusionCost(const Plan& plan, const FrameTimes& times);

/// The same and the passes that `own` names, one flag a pass as ownGeometry has them: what a host
/// pays that draws this geometry for the occlusion alone. Without flags there is none.
double costWithGeometry(const Plan& plan, const FrameTimes& times, const std::vector<bool>& own);

/// "query" (the GPU's timer), "cpu" (processor time of the process) or "wall".
const char* clockName(TimingMethod method);

/// Median and quartiles, interpolated between neighbours. Requires at least one value.
TimeFigures timeFigures(std::vector<double> values);

/// Figures of costs / units turn by turn, over the last turns of the longer; turns where a unit is
/// not above 0 are left out. Zeros when none is left.
TimeFigures ratioFigures(const std::vector<double>& costs, const std::vector<double>& units);

/// Half the width of the interval that holds the median of `count` values at 95 % confidence, a
/// share of it.
double medianMargin(const TimeFigures& figures, std::size_t count);

/// A cost is settled when its margin is at most this.
constexpr double kSettledMargin = 0.03;

/// A renderer that takes turns with others, and what its frames took. Renderer and frame must
/// outlive it.
class TurnTaker {
public:
    /// `own_geometry` has a flag for each pass, see costWithGeometry.
    TurnTaker(Renderer& renderer, const Frame& frame, std::vector<bool> own_geometry = {})
        : renderer_(&renderer),
          frame_(&frame),
          own_geometry_(std::move(own_geometry))
    {
    }

    /// Draws until the turn is long enough to be measured. Errors: those of timeFrame.
    Status takeTurn();

    /// Forgets all turns so far: they were to warm up.
    void restart();

    /// Of all turns.
    const std::vector<FrameTimes>& frames() const { return frames_; }

    /// occlusionCost, the median of each turn.
    const std::vector<double>& costs() const { return costs_; }

    /// costWithGeometry, the median of each turn.
    const std::vector<double>& costsWithGeometry() const { return costs_with_geometry_; }

private:
    Renderer* renderer_;
    const Frame* frame_;
    std::vector<bool> own_geometry_;
    std::vector<FrameTimes> frames_;
    std::vector<double> costs_;
    std::vector<double> costs_with_geometry_;
};

/// `learnopengl` with one's own radius: the unit of costs, which takes turns with what is measured.
/// False, and without any costs, where the device cannot draw it.
class Yardstick {
public:
    Yardstick() = default;

    /// The frame must outlive it.
    Yardstick(Device& device, const SourceSet& sources, Extent extent, const Frame& frame,
              double radius);

    explicit operator bool() const { return turns_.has_value(); }

    /// The first one warms up, and is forgotten. Errors: those of timeFrame.
    Status takeTurn();

    /// The median of each turn.
    const std::vector<double>& costs() const { return turns_ ? turns_->costs() : none_; }

private:
    std::unique_ptr<Renderer> renderer_;
    std::optional<TurnTaker> turns_;
    std::vector<double> none_;
    bool warm_ = false;
};

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
    void measureMotion(const BenchTask& task, Renderer& renderer, HostTextures& host,
                       BenchSample& sample);
    Status measureTimes(const BenchTask& task, Renderer& renderer, const Frame& frame,
                        BenchSample& sample);
    Status writePictures(const BenchTask& task, const Image& ao, BenchSample& sample);

    Device& device_;
    const BenchPlan& plan_;
    const SourceSet& sources_;
    const MeasureOptions options_;
    std::unique_ptr<Setting> setting_;
};

}  // namespace crevice
