// SPDX-License-Identifier: MIT
// The small scenes and cameras that stress cases are made of.
//
// Everything is made in double and rounded once, so that what a case finds is not its own rounding.
//
// Configs run over other geometry modules too, a host's own depth and normals among them.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/measure/stress/case.h"
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

/// What stands in for geometry modules, so that any config that extends one of them becomes one
/// over another. Others stay as they are.
class Substitutes {
public:
    explicit Substitutes(const SourceSet& sources);

    /// Sources in which `geometry`, one of the names below, is extended instead; else those given.
    const SourceSet& over(const std::string& geometry) const;

private:
    struct Layer {
        Layer(MemorySources substitutes, const SourceSet& sources);

        MemorySources modules;
        LayeredSources all;
    };

    const SourceSet& own_;
    std::map<std::string, Layer> over_;
};

constexpr const char* kHostGeometry = "host";
constexpr const char* kPositionGeometry = "positions";
constexpr const char* kLinearGeometry = "linear depth";
constexpr const char* kDepthGeometry = "depth and normals";

/// Depth and normals on a device, of a host that draws the shot's scene and then does to them what
/// the shot says. The device must outlive them. Errors: those of the device.
Result<std::shared_ptr<const std::vector<ImportedTexture>>> changedTextures(Device& device,
                                                                            const StressShot& shot);

}  // namespace crevice
