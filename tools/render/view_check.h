// SPDX-License-Identifier: MIT
// Whether a view shows ambient occlusion at all: how far away its surfaces are, and how large a radius is there.
#pragma once

#include "core/compile/compile.h"
#include "tools/scene/scene.h"

#include <optional>

namespace crevice {

/// Median distance along the view axis of the surfaces in view, at the points of a coarse grid; of the nearest
/// triangle where all of them pass between the points. Nothing where no triangle is in view. On the CPU, so that
/// no plan has to keep its depth.
std::optional<double> medianDistance(const Scene& scene, const Camera& camera);

/// Pixels that a length covers at a distance.
double pixelsOf(double length, double distance, const Camera& camera, Extent extent);

/// Why a frame of the plan shows no ambient occlusion, or none that can be told from a change of brightness:
/// one warning with the value to take, or nothing. `ao` is the picture of it, null where nobody asked for one.
///
/// CV7008 nothing is in view; CV9003 what the plan or the picture has is the same everywhere; CV4001 the radius
/// covers less than two pixels at the median distance, or more than the view.
Diagnostics checkView(const Description& description, const Plan& plan, const Scene& scene,
                      const Camera& camera, const Image* ao);

}  // namespace crevice
