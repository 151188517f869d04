// SPDX-License-Identifier: MIT
// Draws a config along every camera path, and measures how its occlusion changes there, against the
// ray-traced ground truth of these paths.
//
// The noise of the truth's changes has an rms below 0.002
// (tests/tools/measure/motion/figures_test.cpp): 0.0012 in `room` and 0.001 in `spheres`, at
// radius 1.
#pragma once

#include "tools/measure/motion/figures.h"
#include "tools/render/camera_path.h"
#include "tools/render/host_textures.h"

#include <functional>

namespace crevice {

constexpr int kMotionRays = 2048;

/// Frames of a path, as many as a mean over frames takes to gather what it can...
constexpr int kMotionFrames = 32;

/// ... and the last of them that are measured.
constexpr int kMeasuredFrames = 5;

/// What is seen, and what the ground truth takes for it.
struct MotionView {
    const Scene& scene;
    Bounds bounds;
    PathView end;  ///< Of every path.
    double radius = 0;
    std::string cache_folder;  ///< For ground truths; empty for none.
    int rays = kMotionRays;    ///< 0: the truth is taken not to change, which it hardly does.
    std::vector<std::string> paths = {};  ///< Names; empty: all.

    /// Of a frame, [0, kMotionFrames).
    Camera camera(const CameraPath& path, int frame) const;
};

struct MotionTruth {
    std::map<std::string, PathTruth> paths;  ///< Of the measured frames; not of one that jumps.
    Image rest;                              ///< At the end of every path.
    Image uncovered;  ///< 1 where the path that jumps hid before what is seen.
};

/// Stops early, with a part of it, when `interrupted`.
///
/// Errors: those of cachedReference and traceSurfaces, also of a camera that sees no surface on its
/// path.
Result<MotionTruth> traceMotion(const MotionView& view, const std::function<bool()>& interrupted,
                                const std::function<void(double done)>& progress = {});

/// What is drawn with: a renderer that has the output `ao`, what a host hands it, and a frame of
/// the scene whose camera is moved.
struct MotionStage {
    Device& device;
    Renderer& renderer;
    HostTextures& host;
    Frame frame;
};

/// Of the paths that the truth has. Each begins with a cut. A plan without histories draws the
/// measured frames alone.
///
/// Stops early, with a part of the figures, when `interrupted`. Errors: those of Renderer::render
/// and of readOutput, CV4003 for an occlusion that is not a number somewhere.
Result<MotionFigures> measureMotion(const MotionStage& stage, const MotionView& view,
                                    const MotionTruth& truth,
                                    const std::function<bool()>& interrupted);

}  // namespace crevice
