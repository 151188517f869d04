// SPDX-License-Identifier: MIT
// Drawing and reading what the page's slots hold.
#include "tools/show/page/engine/engine.h"

#include <crevice/gl_device.h>

#include "tools/render/read_output.h"

#include <emscripten/html5.h>

namespace crevice::page {

Status Engine::open(const std::string& canvas, const std::string& display_config,
                    const std::string& display_shader, Extent extent)
{
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.antialias = wanted.depth = false;
    wanted.preserveDrawingBuffer = true;  // so that the picture can be saved at any time
    const auto context = emscripten_webgl_create_context(canvas.c_str(), &wanted);
    if (context <= 0)
        return Diagnostic{Code::gl_version, "this browser gives no WebGL 2 context",
                          "switch hardware acceleration on, or try another browser"};
    emscripten_webgl_make_context_current(context);
    GlDeviceOptions options;
    // The context is the page's alone, and to ask for its state takes 10 ms a frame.
    options.restore_state = false;
    auto device = makeGlDevice(emscripten_webgl_get_proc_address, options);
    if (!device) return device.diagnostics();
    Result<Display> display = Display::create(**device, display_config, display_shader, extent);
    if (!display) return display.diagnostics();
    device_ = std::move(*device);
    display_ = std::move(*display);
    stage_.emplace(*device_);
    extent_ = extent;
    return {};
}

Status Engine::load(int slot, const SlotRequest& request)
{
    return slots_[slot].load(*device_, texts_.sources(), request, extent_, frame_);
}

Status Engine::resize(Extent extent)
{
    Status status = display_->resize(extent);
    if (!status) return status;
    extent_ = extent;
    Diagnostics diagnostics;
    for (Slot& slot : slots_)
        if (slot.loaded()) append(diagnostics, slot.renderer().resize(extent).diagnostics());
    return diagnostics;
}

Status Engine::draw(const DrawRequest& request)
{
    const Result<SceneCamera> camera = stage_->camera(request.camera, extent_);
    if (!camera) return camera.diagnostics();
    frame_ = stage_->frameOf(*camera, extent_);
    const bool split = request.split < 1.0f;
    Diagnostics diagnostics;
    Status drawn = slots_[request.left.slot].renderer().render(frame_);
    append(diagnostics, drawn.diagnostics());
    if (drawn && split && request.right.slot != request.left.slot) {
        drawn = slots_[request.right.slot].renderer().render(frame_);
        append(diagnostics, drawn.diagnostics());
    }
    if (!drawn) return diagnostics;
    const Result<Shown> left = shownOf(request.left);
    if (!left) return left.diagnostics();
    const Result<Shown> right = split ? shownOf(request.right) : left;
    if (!right) return right.diagnostics();
    append(diagnostics, display_->draw(*left, *right, request.split).diagnostics());
    return diagnostics;
}

Result<FrameTimes> Engine::timed(int slot) { return slots_[slot].renderer().renderTimed(frame_); }

Status Engine::again(int slot)
{
    ++frame_.revision;
    return slots_[slot].renderer().render(frame_);
}

Result<Image> Engine::read(const Side& side)
{
    const Slot& slot = slots_[side.slot];
    const Result<OutputSource> source = slot.sourceOf(side.show);
    if (!source) return source.diagnostics();
    return readOutput(*device_, slot.renderer(), source->output);
}

Result<Shown> Engine::shownOf(const Side& side)
{
    const Slot& slot = slots_[side.slot];
    const Result<OutputSource> source = slot.sourceOf(side.show);
    if (!source) return source.diagnostics();
    const TextureId texture = slot.renderer().output(source->output);
    const FormatInfo& format = formatInfo(device_->info(texture).format);
    const bool plain = source->scale == 1.0f && source->offset == 0.0f;
    const bool bounded = format.format_class == FormatClass::unorm || side.show == "color";
    if (!plain || bounded)
        return Shown{texture, source->scale, source->offset, format.channels == 1};
    const Result<Image> image = device_->readTexture(texture);
    if (!image) return image.diagnostics();
    return stretched(texture, *image, format.format_class == FormatClass::depth);
}

}  // namespace crevice::page
