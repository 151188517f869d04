// SPDX-License-Identifier: MIT
// The scene of the page on its device, the camera that sees it, and what the canvas shows: one or
// two pictures of slots, beside each other, by a config of its own.
#pragma once

#include "tools/render/scene_upload.h"

#include <crevice/renderer.h>

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

/// A texture and how it is shown.
struct Shown {
    TextureId texture = {};
    float scale = 1.0f;
    float offset = 0.0f;
    bool grey = false;
    bool heat = false;  ///< In its place: black, red, yellow, white.
};

/// Scale and offset that spread what an image holds over [0, 1]: of depth without the background.
Shown stretched(TextureId texture, const Image& image, bool depth);

class Display {
public:
    /// `config` and `shader` are the texts of display.json and display.frag. Errors: those of
    /// loadConfig, decode and Renderer::create.
    static Result<Display> create(Device& device, const std::string& config,
                                  const std::string& shader, Extent extent);

    /// Draws into the canvas. Errors: those of Renderer::render and Device::present.
    Status draw(const Shown& left, const Shown& right, float split);

    Status resize(Extent extent);

private:
    Display(Device& device, std::unique_ptr<Renderer> renderer, Extent extent);

    Device* device_;
    std::unique_ptr<Renderer> renderer_;
    Extent extent_;
};

}  // namespace crevice::page
