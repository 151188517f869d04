// SPDX-License-Identifier: MIT
// Times of frames, and what a bench makes of them.
//
// What is compared takes turns, so that a slow moment of the machine falls on all of it. A turn
// lasts for a while and counts with the median of its frames, since a single frame of a cheap pass
// says little; a ratio is the median over the ratios turn by turn, in which slow moments cancel.
// They do not against a copy of a texture, which was the unit once: that waits for memory where an
// effect computes, and a neighbour on the machine slowed one by 60 % and the other by 3 %.
//
// Source: McGill et al. 1978 - how well a median is known.
#include "tools/measure/bench/measure.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

constexpr int kTimingAttempts = 10;

/// About as long as the scheduler lets another process run. Shorter turns make ratios of cheap
/// passes restless, longer ones only cost time.
constexpr double kTurnMs = 40.0;
constexpr std::size_t kTurnFrames = 64;

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

TimeFigures ratioFigures(const std::vector<double>& costs, const std::vector<double>& units)
{
    std::vector<double> ratios;
    for (auto cost = costs.rbegin(), unit = units.rbegin();
         cost != costs.rend() && unit != units.rend(); ++cost, ++unit)
        if (*unit > 0.0) ratios.push_back(*cost / *unit);
    return ratios.empty() ? TimeFigures() : timeFigures(std::move(ratios));
}

double medianMargin(const TimeFigures& figures, std::size_t count)
{
    if (figures.median <= 0.0) return 0.0;
    return kNotch * (figures.q3 - figures.q1) / figures.median /
           std::sqrt(static_cast<double>(count));
}

Status TurnTaker::takeTurn()
{
    std::vector<double> costs, with_geometry;
    for (double elapsed_ms = 0;
         costs.empty() || (elapsed_ms < kTurnMs && costs.size() < kTurnFrames);) {
        Result<FrameTimes> times = timeFrame(*renderer_, *frame_);
        if (!times) return times.diagnostics();
        costs.push_back(occlusionCost(renderer_->plan(), *times));
        with_geometry.push_back(costWithGeometry(renderer_->plan(), *times, own_geometry_));
        elapsed_ms += times->total_ms;
        frames_.push_back(std::move(*times));
    }
    costs_.push_back(timeFigures(std::move(costs)).median);
    costs_with_geometry_.push_back(timeFigures(std::move(with_geometry)).median);
    return {};
}

void TurnTaker::restart()
{
    frames_.clear();
    costs_.clear();
    costs_with_geometry_.clear();
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

Status Yardstick::takeTurn()
{
    if (!turns_) return {};
    if (!warm_)
        if (const Status drawn = turns_->takeTurn(); !drawn) return drawn;
    if (!warm_) turns_->restart();
    warm_ = true;
    return turns_->takeTurn();
}

}  // namespace crevice
