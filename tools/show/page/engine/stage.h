// SPDX-License-Identifier: MIT
// The scene of the page on its device, and the camera that sees it.
#pragma once

#include "tools/render/scene_upload.h"

#include <nlohmann/json_fwd.hpp>

namespace crevice::page {

class Stage {
public:
    explicit Stage(Device& device) : device_(&device) {}

    /// Uploads a scene in the place of the one before. Errors: CV7003 for one without triangles;
    /// those of UploadedScene::upload. The scene of before stays.
    Status show(Scene scene);

    const Scene& scene() const { return scene_; }

    /// {"name", "diagonal", "cameras"}.
    nlohmann::json state() const;

    /// A camera as `--camera` says it. Errors: those of chooseCamera.
    Result<SceneCamera> camera(const std::string& text, Extent extent) const;

    /// {"eye", "at", "up", "fov_deg" or "ortho_height"}: looks at what lies in the middle of the
    /// view, at the median distance. Errors: those of chooseCamera and of drawing depth.
    Result<nlohmann::json> resolve(const std::string& text, Extent extent) const;

    /// The frame that the camera sees.
    Frame frameOf(const SceneCamera& camera, Extent extent) const;

private:
    Device* device_;
    Scene scene_;
    std::optional<UploadedScene> uploaded_;
};

}  // namespace crevice::page
