// SPDX-License-Identifier: MIT
// A renderer's output as an image in CPU memory, and how far away what a view shows is.
#pragma once

#include <crevice/compile.h>
#include <crevice/renderer.h>

namespace crevice {

/// Frames of a still view by when a mean over frames has gathered what it can.
constexpr int kGatheringFrames = 32;

/// Reads a view's output back. One that the plan found to be constant has a single texel, spread
/// out here over the plan's extent. Requires an output that the renderer was made for, and a frame
/// drawn.
///
/// Errors: those of Device::readTexture.
Result<Image> readOutput(Device& device, const Renderer& renderer, std::string_view name,
                         int view = 0);

/// Whether what a frame shows depends on the frames before it.
bool remembers(const Plan& plan);

/// Draws the frame and reads an output. A plan with histories draws it kGatheringFrames times, so
/// that the picture does not depend on what was drawn before.
///
/// Errors: those of Renderer::render and of readOutput.
Result<Image> drawSettled(Device& device, Renderer& renderer, const Frame& frame,
                          std::string_view name);

/// Draws nothing but depth, where the radius on screen comes from.
constexpr const char* kDepthModule = "command/depth.json";

/// Window depths of a frame's first view, 1 in the background: no plan has to keep its own.
/// Errors: those of Renderer::create, Renderer::render and Device::readTexture.
Result<Image> drawDepth(Device& device, Frame frame, Extent extent);

/// Nothing of nothing.
std::optional<double> medianOf(std::vector<double> values);

/// Median distance along the view axis of what window depths of the camera show. Nothing where that
/// is the background alone, which is 1, or 0 of a camera whose depth is reversed.
std::optional<double> medianDistance(const Image& depth, const Camera& camera);

/// How a request is met: the config's output that holds the pixels, and how a view shows them.
struct OutputSource {
    std::string output;
    float scale = 1.0f;
    float offset = 0.0f;
};

/// Finds the name among outputs, then views, then targets ("target.ao" where an output hides it),
/// and has the description export the target behind it. Errors: CV2209 with the names that would
/// do.
Result<OutputSource> exposeOutput(Description& description, const std::string& name);

/// value * scale + offset in every channel.
void applyView(Image& image, const OutputSource& source);

/// A target that is looked at, and the output that shows it.
struct WatchedTarget {
    std::string target;
    std::string pass;
    std::string output;
};

/// The format that the plan has for a target of its own.
Format formatOf(const Plan& plan, const std::string& target);

/// Has the description export every target that a pass of the plan writes, in the passes' order.
std::vector<WatchedTarget> watchAll(const Plan& plan, Description& description);

}  // namespace crevice
