// SPDX-License-Identifier: MIT
// How error and cost grow: bench samples joined to curves, with a power law fitted to each.
#pragma once

#include "tools/measure/bench/pareto.h"
#include "tools/measure/bench/views.h"

#include <optional>
#include <string>
#include <vector>

namespace crevice {

/// What a curve shows; also its name in a report.
///
///     error_samples  rmse over depth taps         cost_samples    ms over depth taps
///     taps_samples   the part of it that all      cost_pixels     ms over pixels
///                    taps would take away         cost_radius     ms over the radius on screen
///                                                 cost_triangles  ms of a frame over triangles
struct Curve {
    std::string kind;
    std::string label;  ///< The family for curves over sample counts, else the sample's label.
    std::string family;
    std::vector<XY> points;  ///< By rising x, at least two different.
    std::optional<PowerLaw> law;
};

/// Over samples within one view; over pixels and radius on screen of its device, scene and camera.
std::vector<Curve> curvesOf(const std::vector<BenchSample>& samples, const ResultView& view);

/// Cost over triangles, across the main views of one device.
std::vector<Curve> curvesAcross(const std::vector<BenchSample>& samples,
                                const std::vector<ResultView>& main_views);

}  // namespace crevice
