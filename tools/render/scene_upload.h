// SPDX-License-Identifier: MIT
// A scene on a device: its meshes and textures, and the frames drawn from them.
#pragma once

#include "core/gpu/owned.h"
#include "tools/render/scene/scene.h"

namespace crevice {

/// Owns the device objects of one scene. The device must outlive it.
class UploadedScene {
public:
    /// Meshes without triangles are left out. Textures become rgba16f, so that dark linear colours
    /// keep their steps.
    ///
    /// Errors: those of the device; nothing is left behind on it.
    static Result<UploadedScene> upload(Device& device, const Scene& scene);

    const Bounds& bounds() const { return bounds_; }

private:
    friend Frame makeFrame(const UploadedScene&, const SceneCamera&, Extent);

    Status uploadTextures(Device& device, const Scene& scene);
    Status uploadMeshes(Device& device, const Scene& scene);

    std::vector<Owned<TextureId>> textures_;
    std::vector<Owned<MeshId>> meshes_;
    Frame frame_;  // all but the camera
    Bounds bounds_;
};

/// A frame of the scene as `camera` sees it. The ids in it belong to `scene`.
Frame makeFrame(const UploadedScene& scene, const SceneCamera& camera, Extent extent);

}  // namespace crevice
