// SPDX-License-Identifier: MIT
// The textures of a surface that a config imports, drawn as its host would.
#pragma once

#include <crevice/config.h>
#include <crevice/renderer.h>

#include <memory>

namespace crevice {

/// Draws depth, normals, distances or positions of a scene, of which it knows `depth`, `normal`,
/// `linear_depth`, `log_depth` and `position`. The device must outlive it.
class HostTextures {
public:
    /// For what the description imports of these and the frame does not have, each in the import's
    /// format where the device draws to that; where that is nothing, nothing is made. Errors: those
    /// of Renderer::create.
    static Result<HostTextures> make(Device& device, const Description& description, Extent extent,
                                     const Frame& scene);

    /// The frame that such a host hands over: its cameras and lights, with the textures, drawn now,
    /// and the draws only where the description imports them. Holds until the next. Errors: those
    /// of Renderer::render.
    Result<Frame> frameOf(const Frame& scene);

private:
    std::unique_ptr<Renderer> renderer_;  // null where nothing is imported
    std::vector<std::string> names_;
    bool draws_ = true;
};

}  // namespace crevice
