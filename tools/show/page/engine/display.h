// SPDX-License-Identifier: MIT
// What the canvas shows: one or two pictures of slots, beside each other, by a config of its own.
#pragma once

#include <crevice/renderer.h>

namespace crevice::page {

/// A texture and how it is shown.
struct Shown {
    TextureId texture = {};
    float scale = 1.0f;
    float offset = 0.0f;
    bool grey = false;
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
