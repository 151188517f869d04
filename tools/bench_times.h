// SPDX-License-Identifier: MIT
// Times of frames, and what a bench makes of them.
#pragma once

#include "tools/bench_point.h"

#include "core/renderer.h"

#include <vector>

namespace crevice {

/// Draws a frame until its times are valid: a GPU's timer may be disturbed now and then.
/// Errors: those of Renderer::renderTimed; CV6005 when the timer is disturbed time after time.
Result<FrameTimes> timeFrame(Renderer& renderer, const Frame& frame);

/// The sum over the passes that are no draw passes: what a host with a G-buffer pays for the occlusion.
double occlusionCost(const Plan& plan, const FrameTimes& times);

/// Median and quartiles, interpolated between neighbours. Requires at least one value.
TimeFigures timeFigures(std::vector<double> values);

}  // namespace crevice
