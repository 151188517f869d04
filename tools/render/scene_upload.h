// SPDX-License-Identifier: MIT
// A scene on a device: its meshes and textures, and the frames drawn from them.
#pragma once

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

    ~UploadedScene();
    UploadedScene(UploadedScene&& other) noexcept;
    UploadedScene& operator=(UploadedScene&& other) noexcept;

    const Bounds& bounds() const { return bounds_; }

private:
    friend Frame makeFrame(const UploadedScene&, const SceneCamera&, Extent);

    explicit UploadedScene(Device& device) : device_(&device) {}
    Status uploadTextures(const Scene& scene);
    Status uploadMeshes(const Scene& scene);
    void destroy();

    Device* device_;
    std::vector<TextureId> textures_;
    std::vector<MeshId> meshes_;
    Frame frame_;  // all but the camera
    Bounds bounds_;
};

/// A frame of the scene as `camera` sees it. The ids in it belong to `scene`.
Frame makeFrame(const UploadedScene& scene, const SceneCamera& camera, Extent extent);

}  // namespace crevice
