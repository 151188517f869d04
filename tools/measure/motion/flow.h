// SPDX-License-Identifier: MIT
// Where surface points are from one frame to the next, and how occlusion changes there.
//
// Each pixel's point, ray-traced, is projected into the next frame. What that frame has there is
// interpolated between the four texels about the place, and counts only where all of them lie on
// the point's own surface: no farther off its tangent plane than a pixel covers at the point. So
// edges, what comes into view and what goes out of it do not count, and a crease does. The ground
// truth is interpolated in the same way, so that what interpolation itself changes is in both.
#pragma once

#include "tools/measure/reference/tracer.h"

namespace crevice {

/// For each pixel of `from` its place in `to`, in texels from the centre of the first: two
/// channels, NaN where it does not count. `camera` is the one that saw `to`.
Image flowTo(const SurfaceMap& from, const SurfaceMap& to, const Camera& camera);

/// 1 for each pixel of `now` whose point lies within the picture `before` and is hidden there; else
/// 0. `camera` is the one that saw `before`.
Image uncoveredSince(const SurfaceMap& before, const Camera& camera, const SurfaceMap& now);

/// The change from one frame to the next at the same points, one channel; NaN where `flow` is.
Image changeAlong(const Image& flow, const Image& from, const Image& to);

}  // namespace crevice
