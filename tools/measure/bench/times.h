// SPDX-License-Identifier: MIT
// Times of frames, and what a bench makes of them.
//
// What is compared takes turns, so that a slow moment of the machine falls on all of it. A turn
// lasts for a while and counts with the median of its frames, since a single frame of a cheap pass
// says little; a ratio is the median over the ratios turn by turn, in which slow moments cancel.
// They do not against a copy of a texture, which was the unit once: that waits for memory where an
// effect computes, and a neighbour on the machine slowed one by 60 % and the other by 3 %.
//
// Who draws and times a frame is left open: a command does it here and now, a browser says what a
// frame took only after a while.
//
// Source: McGill et al. 1978 - how well a median is known.
#pragma once

#include "tools/measure/bench/sample.h"

#include <crevice/renderer.h>
#include <crevice/source.h>

#include <functional>

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

/// costs / units turn by turn, over the last turns of the longer; turns where a unit is not above 0
/// are left out.
std::vector<double> ratiosOf(const std::vector<double>& costs, const std::vector<double>& units);

/// Figures of ratiosOf(). Zeros when none is left.
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

    Renderer& renderer() const { return *renderer_; }
    const Frame& frame() const { return *frame_; }

    /// Takes what a frame of it took; the first one of all only warmed up. True where that ends a
    /// turn.
    bool add(FrameTimes times);

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
    bool warm_ = false;
    std::vector<FrameTimes> frames_;
    std::size_t turn_begin_ = 0;  // into frames_
    std::vector<double> costs_;
    std::vector<double> costs_with_geometry_;
};

/// Turns of one and, after each, of what it is compared with. Both must outlive it.
class Turns {
public:
    /// So many of each at least, and at most, between which they end once the ratio is settled.
    /// Where `unit` is null there is nothing to compare with, and the costs are to settle.
    Turns(TurnTaker& taker, TurnTaker* unit, int least, int most)
        : taker_(taker),
          unit_(unit),
          least_(least),
          most_(most)
    {
    }

    /// Whose frame is to be drawn and timed next; null once all turns are taken.
    TurnTaker* next() const;

    /// Takes what that frame took.
    void add(FrameTimes times);

    /// Takes all that are left, here and now, or stops when `interrupted`. `before` comes before
    /// each frame. Errors: those of timeFrame and `before`.
    Status take(const std::function<bool()>& interrupted,
                const std::function<Status(const TurnTaker&)>& before = {});

    /// Of each turn so far; of a unit that was there before, of those that were taken here.
    std::vector<double> ratios() const;

private:
    TurnTaker& taker_;
    TurnTaker* unit_;
    int least_, most_;
    int taken_ = 0;
    bool is_units_ = false;  // the turn that is under way
    bool settled_ = false;
};

/// `learnopengl` with one's own radius: the unit of costs, which takes turns with what is measured.
class Yardstick {
public:
    Yardstick() = default;

    /// The frame must outlive it.
    Yardstick(Device& device, const SourceSet& sources, Extent extent, const Frame& frame,
              double radius);

    /// Null where the device cannot draw it.
    TurnTaker* turns() { return turns_ ? &*turns_ : nullptr; }

private:
    std::unique_ptr<Renderer> renderer_;
    std::optional<TurnTaker> turns_;
};

}  // namespace crevice
