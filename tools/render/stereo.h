// SPDX-License-Identifier: MIT
// Two eyes in the place of one camera, and their pictures side by side.
//
// The eyes stand side by side on the camera's x axis and look where it looks: neither is turned, so
// that no point is higher in one picture than in the other. Off-centre projections bring the two
// pictures together at the distance of convergence: what lies there is at one place in both.
#pragma once

#include "tools/render/scene/scene.h"

namespace CLI {
class App;
}

namespace crevice {

struct StereoOptions {
    double separation = 0.0;   ///< --stereo: between the eyes, scene units; 0 is one eye.
    double convergence = 0.0;  ///< --convergence: from the eyes, scene units; 0 is infinitely far.
};

void addStereoOptions(CLI::App& app, StereoOptions& options);

/// The camera of an eye `offset` scene units to the right of `camera`, whose aspect is width over
/// height. Requires a perspective camera.
SceneCamera eyeCamera(const SceneCamera& camera, double offset, double convergence, double aspect);

/// Two cameras, left and right; `camera` alone where no separation is asked for.
/// Errors: CV8001 for an orthographic camera, in which two eyes see one picture.
Result<std::vector<SceneCamera>> eyeCameras(const SceneCamera& camera, const StereoOptions& options,
                                            double aspect);

/// `right` to the right of `left`. Requires pictures of one size and number of channels.
Image sideBySide(const Image& left, const Image& right);

}  // namespace crevice
