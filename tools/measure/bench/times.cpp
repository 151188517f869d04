// SPDX-License-Identifier: MIT
#include "tools/measure/bench/times.h"

#include "tools/commands/cli/load_config.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr int kTimingAttempts = 10;

/// About as long as the scheduler lets another process run. Shorter turns make ratios of cheap
/// passes restless, longer ones only cost time. A GPU's timer knows of no scheduler.
constexpr double kTurnMs = 40.0;
constexpr std::size_t kTurnFrames = 64, kTurnFramesOfGpu = 8;

/// The half width of a median's interval of 95 % confidence is this times the interquartile range
/// over the root of the count (McGill et al. 1978, its factor 1.57).
constexpr double kNotch = 1.57;

/// Of values in rising order, interpolated between neighbours.
double quantile(const std::vector<double>& sorted, double share)
{
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return sorted[low] + (sorted[high] - sorted[low]) * (place - static_cast<double>(low));
}

}  // namespace

Result<FrameTimes> timeFrame(Renderer& renderer, const Frame& frame)
{
    for (int attempt = 0; attempt < kTimingAttempts; ++attempt) {
        Result<FrameTimes> times = renderer.renderTimed(frame);
        if (!times || times->total_ms >= 0.0) return times;
    }
    return Diagnostic{Code::gl_error, "the GPU's timer gave no valid result in " +
                                          std::to_string(kTimingAttempts) + " frames"};
}

double occlusionCost(const Plan& plan, const FrameTimes& times)
{
    double sum = 0;
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        if (plan.passes[pass].type != PassType::draw) sum += times.pass_ms[pass];
    return sum;
}

double costWithGeometry(const Plan& plan, const FrameTimes& times, const std::vector<bool>& own)
{
    double sum = occlusionCost(plan, times);
    for (std::size_t pass = 0; pass < own.size(); ++pass)
        if (own[pass]) sum += times.pass_ms[pass];
    return sum;
}

const char* clockName(TimingMethod method)
{
    const char* const names[] = {"wall", "query", "cpu"};
    return names[static_cast<int>(method)];
}

TimeFigures timeFigures(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

std::vector<double> ratiosOf(const std::vector<double>& costs, const std::vector<double>& units)
{
    std::vector<double> ratios;
    const std::size_t count = std::min(costs.size(), units.size());
    for (std::size_t i = count; i > 0; --i)
        if (units.end()[-i] > 0.0) ratios.push_back(costs.end()[-i] / units.end()[-i]);
    return ratios;
}

TimeFigures ratioFigures(const std::vector<double>& costs, const std::vector<double>& units)
{
    std::vector<double> ratios = ratiosOf(costs, units);
    return ratios.empty() ? TimeFigures() : timeFigures(std::move(ratios));
}

double medianMargin(const TimeFigures& figures, std::size_t count)
{
    if (figures.median <= 0.0) return 0.0;
    return kNotch * (figures.q3 - figures.q1) / figures.median /
           std::sqrt(static_cast<double>(count));
}

bool TurnTaker::add(FrameTimes times)
{
    if (!std::exchange(warm_, true)) return false;
    frames_.push_back(std::move(times));
    const std::size_t count = frames_.size() - turn_begin_;
    const bool by_gpu = frames_.back().method == TimingMethod::gpu_timer;
    double elapsed_ms = 0;
    for (std::size_t i = turn_begin_; i < frames_.size(); ++i) elapsed_ms += frames_[i].total_ms;
    if (elapsed_ms < kTurnMs && count < (by_gpu ? kTurnFramesOfGpu : kTurnFrames)) return false;
    std::vector<double> costs, with_geometry;
    for (; turn_begin_ < frames_.size(); ++turn_begin_) {
        const FrameTimes& frame = frames_[turn_begin_];
        costs.push_back(occlusionCost(renderer_->plan(), frame));
        with_geometry.push_back(costWithGeometry(renderer_->plan(), frame, own_geometry_));
    }
    costs_.push_back(timeFigures(std::move(costs)).median);
    costs_with_geometry_.push_back(timeFigures(std::move(with_geometry)).median);
    return true;
}

TurnTaker* Turns::next() const
{
    if (taken_ >= most_ || (taken_ >= least_ && settled_)) return nullptr;
    return is_units_ ? unit_ : &taker_;
}

void Turns::add(FrameTimes times)
{
    if (!next()->add(std::move(times))) return;
    if (unit_ && !std::exchange(is_units_, !is_units_)) return;
    ++taken_;
    const TimeFigures figures =
        unit_ && !ratios().empty() ? timeFigures(ratios()) : timeFigures(taker_.costs());
    settled_ = medianMargin(figures, taker_.costs().size()) <= kSettledMargin;
}

Status Turns::take(const std::function<bool()>& interrupted,
                   const std::function<Status(const TurnTaker&)>& before)
{
    while (TurnTaker* taker = interrupted() ? nullptr : next()) {
        if (before)
            if (const Status ready = before(*taker); !ready) return ready;
        Result<FrameTimes> times = timeFrame(taker->renderer(), taker->frame());
        if (!times) return times.diagnostics();
        add(std::move(*times));
    }
    return {};
}

std::vector<double> Turns::ratios() const
{
    return unit_ ? ratiosOf(taker_.costs(), unit_->costs()) : std::vector<double>();
}

Yardstick::Yardstick(Device& device, const SourceSet& sources, Extent extent, const Frame& frame,
                     double radius)
{
    Result<Description> described = loadDescription({"learnopengl", {}, {}, {}}, sources);
    if (!described) return;
    auto made = Renderer::create(device, std::move(*described), {extent, {kOcclusionOutput}, {}},
                                 traitsOf(frame));
    if (!made || !(*made)->setParam("radius", static_cast<float>(radius))) return;
    renderer_ = std::move(*made);
    turns_.emplace(*renderer_, frame);
}

}  // namespace crevice
