// SPDX-License-Identifier: MIT
// The page's library: a canvas, a scene in it, configs that draw it, and what is known of them.
// exports.cpp hands all of it to JavaScript.
#pragma once

#include "tools/show/page/engine/display.h"
#include "tools/show/page/engine/slot.h"
#include "tools/show/page/engine/stage.h"
#include "tools/show/page/engine/texts.h"

#include <array>

namespace crevice::page {

/// A slot, and which of its outputs, views or targets.
struct Side {
    int slot = 0;
    std::string show;
};

struct DrawRequest {
    std::string camera;  ///< As `--camera` has it.
    Side left = {};
    Side right = {};
    float split = 1.0f;  ///< Share of the width that shows `left`.
};

class Engine {
public:
    static constexpr int kSlots = 4;

    /// Makes a WebGL 2 context on the canvas that the selector names. Errors: those of makeGlDevice
    /// and Display::create; CV6004 where the browser gives no context.
    Status open(const std::string& canvas, const std::string& display_config,
                const std::string& display_shader, Extent extent);

    Texts& texts() { return texts_; }
    Stage& stage() { return *stage_; }
    Slot& slot(int index) { return slots_[index]; }
    Device& device() { return *device_; }
    Extent extent() const { return extent_; }

    Status load(int slot, const SlotRequest& request);

    /// Of the display and of all slots. Errors: those of Renderer::resize.
    Status resize(Extent extent);

    /// Draws both sides' slots, and the canvas. Errors: those of chooseCamera, of Renderer::render
    /// and of sourceOf.
    Status draw(const DrawRequest& request);

    /// Draws a slot once more for the view that was drawn last, every pass of it, and measures
    /// that. Errors: those of Renderer::renderTimed.
    Result<FrameTimes> timed(int slot);

    /// Draws a slot for the view that was drawn last, every pass of it, without a wait.
    Status again(int slot);

    /// What a slot shows under a name, as values. Errors: those of sourceOf and
    /// Device::readTexture.
    Result<Image> read(const Side& side);

private:
    Result<Shown> shownOf(const Side& side);

    Texts texts_;
    std::unique_ptr<Device> device_;
    std::optional<Display> display_;
    std::optional<Stage> stage_;
    std::array<Slot, kSlots> slots_;
    Frame frame_;  // of the last draw
    Extent extent_;
};

}  // namespace crevice::page
