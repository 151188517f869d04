// SPDX-License-Identifier: MIT
// Whether a view shows ambient occlusion at all: how far away its surfaces are, and how large a
// radius is there.
#pragma once

#include "tools/render/host_pictures.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"

namespace crevice {

/// Pixels that a length covers at a distance.
double pixelsOf(double length, double distance, const Camera& camera, Extent extent);

/// Why a frame of the plan shows no ambient occlusion, or none that can be distinguished from a
/// change of brightness: one warning with the value to take, or nothing. `distance` is the median
/// one in view, `ao` the picture of occlusion, null where nobody asked for one.
///
/// CV7008 nothing is in view; CV9003 what the plan or the picture has is the same everywhere;
/// CV4001 the radius covers less than two pixels at the median distance, more than the view, or too
/// few of the occlusion's own pixels, where that is smaller than the view.
Diagnostics checkView(const Description& description, const Plan& plan, const Scene& scene,
                      const Camera& camera, std::optional<double> distance, const Image* ao);

/// Puts lengths into scene units; says what they were: "radius 5 % of the scene = 0.31", or "".
/// Pixels need the depth of the view, which a context of that backend then draws.
///
/// Errors: those of openDevice and drawDepth; CV7008 for pixels where no surface is seen.
Result<std::string> resolveLengths(Description& description, const HostPictures& pictures);
Result<std::string> resolveLengths(Description& description, const Scene& scene,
                                   const Bounds& bounds, const SceneCamera& seen, Extent extent,
                                   const std::string& backend = {});
inline Result<std::string> resolveLengths(Description& description, const SceneView& view,
                                          const std::string& backend = {})
{
    return resolveLengths(description, view.scene, view.bounds, view.camera, view.extent, backend);
}

}  // namespace crevice
