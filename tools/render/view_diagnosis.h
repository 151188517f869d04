// SPDX-License-Identifier: MIT
// Whether a view shows ambient occlusion at all: how far away its surfaces are, and how large a
// radius is there.
#pragma once

#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"

#include <functional>

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

/// Median distance along the view axis of what a frame shows, whose depth is drawn for it. Errors:
/// those of drawDepth; CV7008 where that is the background alone.
Result<double> medianDistance(Device& device, const Frame& frame, Extent extent);

/// The same, on a context of its own of that backend. Errors: also those of openDevice.
Result<double> medianDistance(const Scene& shown, const SceneCamera& camera, Extent extent,
                              const std::string& backend = {});

/// Puts lengths into scene units; says what they were: "radius 5 % of the scene = 0.31", or "".
/// `distance` is the median one in view, asked for where a length needs it; `diagonal` is the
/// scene's, 0 without one. Errors: those of `distance`; CV8001 for a share of no scene.
Result<std::string> resolveLengths(Description& description, const Camera& camera, Extent extent,
                                   double diagonal,
                                   const std::function<Result<double>()>& distance);

/// The same of a scene, by medianDistance on a context of its own, and of pictures.
Result<std::string> resolveLengths(Description& description, const SceneView& view,
                                   const std::string& backend = {});
Result<std::string> resolveLengths(Description& description, const HostPictures& pictures);

}  // namespace crevice
