// SPDX-License-Identifier: MIT
// Draws a config along every camera path, and measures how its occlusion changes there.
#pragma once

#include "tools/measure/motion/truth.h"
#include "tools/render/host_textures.h"

namespace crevice {

/// What is drawn with: a renderer that has the output `ao`, what a host hands it, and a frame of
/// the scene whose camera is moved.
struct MotionStage {
    Device& device;
    Renderer& renderer;
    HostTextures& host;
    Frame frame;
};

/// Each path begins with a cut. A plan without histories draws the measured frames alone.
///
/// Stops early, with a part of the figures, when `interrupted`. Errors: those of Renderer::render
/// and of readOutput, CV4003 for an occlusion that is not a number somewhere.
Result<MotionFigures> measureMotion(const MotionStage& stage, const MotionView& view,
                                    const MotionTruth& truth,
                                    const std::function<bool()>& interrupted);

}  // namespace crevice
