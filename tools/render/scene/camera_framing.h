// SPDX-License-Identifier: MIT
// Choosing a camera: the scene's own, one that frames the scene, or one from the command line.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

const glm::dvec3 kThreeQuarter = {0.55, 0.45, 1.0};  ///< Right, above, mostly in front.

/// A view, with the eye on that side, that holds all of the scene at `aspect` (width over height,
/// > 0) with a small margin; its name is "framing".
SceneCamera frameScene(const Scene& scene, double aspect, const glm::dvec3& side = kThreeQuarter);

/// What `--camera TEXT` asks for:
///   ""      the scene's first camera in whose view a mesh may be, or `frameScene` without one
///   "NAME"  the scene's camera of that name
///   "frame", "frame=top"
///           `frameScene`, from "iso" (kThreeQuarter, as without a word), "front" (+z), "back",
///           "left" (-x), "right" or "top"
///   "eye=4,2,6;at=0,1,0;up=0,1,0;fov=50;near=0.1;far=100"
///           a view of one's own: `fov` is vertical and in degrees (default 50), or `ortho=3` is
///           the height of an orthographic view in scene units; only `eye` must be there; `at` is
///           the centre of the scene, `up` is +y, near and far follow the bounds unless given;
///           `shift=0.5,0` looks off-centre, at what lies half a picture further to the right.
///
/// Errors: CV7004 for a name that the scene does not have; CV8001 for text that cannot be read,
/// CV4001 and CV4003 for values that no camera can have.
Result<SceneCamera> chooseCamera(const Scene& scene, const Bounds& bounds, const std::string& text,
                                 double aspect);

/// That camera in the words of `--camera`, with the near and far distances that it has here.
std::string cameraText(const SceneCamera& camera, const Bounds& bounds);

}  // namespace crevice
