// SPDX-License-Identifier: MIT
// The view that a bench draws in, and a config that is drawn there.
#pragma once

#include "tools/measure/bench/sample.h"
#include "tools/render/host_textures.h"
#include "tools/render/scene/scene.h"

namespace crevice {

/// What several samples look at.
struct BenchView {
    std::shared_ptr<const Scene> scene;
    Bounds bounds;
    SceneCamera camera;
    Extent extent;

    Camera matrices() const;
};

/// Whether its figures say most about what to take (docs/which_config.md), so that it is measured
/// first. `reference`, which takes too long, is none.
bool isPresetConfig(std::string_view config);

/// A config's renderer with what a host hands it. The device must outlive it.
struct Drawn {
    std::optional<HostTextures> host;
    Frame frame;  ///< Of the host; its textures hold until the host's next one.
    std::unique_ptr<Renderer> renderer;

    /// Takes what a host hands over in the scene's frame, and makes the renderer; one that is there
    /// takes the extent alone. Errors: those of HostTextures, Renderer::create and
    /// Renderer::resize.
    Status prepare(Device& device, const Description& description, const Frame& scene,
                   const CompileOptions& options);

    /// Takes the host's frame for another of the scene, or again after its camera was moved.
    /// Requires `prepare`. Errors: those of Renderer::render.
    Status handOver(const Frame& scene);

    /// Lets go of all textures, and keeps the programs: many are known at once.
    void rest();
};

}  // namespace crevice
