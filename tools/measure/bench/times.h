// SPDX-License-Identifier: MIT
// Times of frames, and what a bench makes of them.
//
// What is compared takes turns, so that a slow moment of the machine falls on all of it. A turn
// lasts for a while and counts with the median of its frames, since a single frame of a cheap pass
// says little; a ratio is the median over the ratios turn by turn, in which slow moments cancel.
//
// They do not cancel against a copy of a texture: that waits for memory where the effect computes,
// and a neighbour on the machine was seen to slow one by 60 % and the other by 3 %, for many
// seconds. So the cost of the copy is compared with that of `learnopengl` at their quickest, over
// all turns of a view.
//
// Source: McGill et al. 1978 - how well a median is known.
#pragma once

#include "tools/measure/bench/sample.h"

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

/// The first decile, which no slow moment reaches. Requires at least one value.
double quickest(std::vector<double> costs);

/// True when the median of `count` values is known to within 3 %, at 95 % confidence.
bool isSettled(const TimeFigures& figures, std::size_t count);

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

}  // namespace crevice
