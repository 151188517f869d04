// SPDX-License-Identifier: MIT
// How far away what a view shows is, by its depth.
#pragma once

#include <crevice/device.h>
#include <crevice/frame.h>

#include <optional>

namespace crevice {

/// Draws nothing but depth, where the copy cost of a bench and the radius on screen come from.
constexpr const char* kDepthModule = "command/depth.json";

/// Window depths of a frame's first view, 1 in the background: no plan has to keep its own.
/// Errors: those of Renderer::create, Renderer::render and Device::readTexture.
Result<Image> drawDepth(Device& device, Frame frame, Extent extent);

/// Median distance along the view axis of what such depths show. Nothing where that is the
/// background alone.
std::optional<double> medianDistance(const Image& depth, const Camera& camera);

}  // namespace crevice
