// SPDX-License-Identifier: MIT
// Built-in camera paths: how a camera moves from frame to frame, for pictures of motion.
//
// A path starts from any camera and is measured in pixels of the picture, so that it fits every
// scene. Its last frame is that camera itself.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// The camera that a path ends at, and what turns pixels into lengths.
struct PathView {
    SceneCamera camera;
    Extent extent;
    double distance = 1.0;  ///< The median one in view, along the axis; scene units.
};

/// How the camera moves. One that turns is moved where it is orthographic, by the same pixels.
struct CameraPath {
    const char* name;
    const char* what;     ///< In a few words, for help.
    double turn_px[2];    ///< To the right and up, a frame, in the middle of the picture.
    double step_px;       ///< Moved to the right, a frame, at `distance`.
    double aside_px = 0;  ///< Stands that far to the left of where it ends, at `distance`, ...
};

/// ... but for the last frames, so many; or for half of them where there are fewer than twice that.
constexpr int kFramesAfterJump = 16;

constexpr CameraPath kCameraPaths[] = {
    {"still", "stands still", {0, 0}, 0},
    {"sub-pixel", "turns by 0.15 pixels a frame", {0.12, 0.09}, 0},
    {"pan", "turns by 5 pixels a frame", {5, 0}, 0},
    {"strafe", "moves sideways by 3 pixels a frame at the median distance", {0, 0}, 3},
    {"disocclusion", "jumps sideways by 32 pixels at the median distance", {0, 0}, 0, 32},
};

/// Errors: CV8001 for a name that no path has.
Result<CameraPath> findCameraPath(const std::string& name);

/// The camera of a frame, [0, frames).
SceneCamera cameraAt(const CameraPath& path, const PathView& view, int frame, int frames);

}  // namespace crevice
