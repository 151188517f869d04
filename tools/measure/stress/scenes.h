// SPDX-License-Identifier: MIT
// The small scenes and cameras that stress cases are made of.
//
// Everything is made in double and rounded once, so that what a case finds is not its own rounding.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// A view along -z.
struct StressView {
    glm::dvec3 eye = {0, 0, 0};
    double fov_degrees = 45;
    double half_height = 0;  ///< Above 0: orthographic.
    double near_distance = 0.1;
    double far_distance = 100;
    bool infinite = false;  ///< The far plane lies infinitely far.
    bool reversed = false;  ///< Near is at depth 1, far at 0.
    int shift_px = 0;       ///< Off-centre: what lies that many pixels further right.
};

Camera cameraOf(const StressView& view, Extent size);

/// A plane through (0, 0, -distance) and how far each pixel sees it.
struct PlaneView {
    Scene scene;
    Image distances;  ///< Along the view axis; 0 where a pixel does not show the plane.
};

/// `tilt` is the angle off facing the camera. The plane reaches past the borders of the view, where
/// that is not too far. `view.eye` must be the origin.
PlaneView planeView(const StressView& view, Extent size, double distance, double tilt_degrees);

/// A floor and two walls with boxes, a pole and a sphere, all closed, seen from (0, 1, 5).
/// Everything lies in the vertices, each model matrix is one, and lights shine.
Scene testScene();

/// A floor and a wall that meet in the x axis, seen from (0, 1, 4).
Scene cornerScene();

/// `first` after each instance's own matrix.
Scene placed(Scene scene, const glm::dmat4& first);

/// The same with the matrices worked into the vertices.
Scene baked(Scene scene);

}  // namespace crevice
