// SPDX-License-Identifier: MIT
// Showing pictures in the canvas.
#include "tools/show/page/engine/display.h"

#include <crevice/shipped.h>

#include <algorithm>
#include <cmath>

namespace crevice::page {

Shown stretched(TextureId texture, const Image& image, bool depth)
{
    float least = 1e30f, most = -1e30f;
    for (const float value : image.pixels) {
        if (!std::isfinite(value) || (depth && value >= 1.0f)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    Shown shown = {texture};
    shown.grey = image.channels == 1;
    if (!(most > least)) return shown;
    shown.scale = 1.0f / (most - least);
    shown.offset = -least * shown.scale;
    return shown;
}

Display::Display(Device& device, std::unique_ptr<Renderer> renderer, Extent extent)
    : device_(&device),
      renderer_(std::move(renderer)),
      extent_(extent)
{
}

Result<Display> Display::create(Device& device, const std::string& config,
                                const std::string& shader, Extent extent)
{
    MemorySources own;
    own.add("configs/display.json", config);
    own.add("page/display.frag", shader);
    const LayeredSources sources({&own, &shippedSources()});
    const Result<Node> document = loadConfig(sources, {"display"});
    if (!document) return document.diagnostics();
    Result<Description> description = decode(*document, sources);
    if (!description) return description.diagnostics();
    auto renderer = Renderer::create(device, std::move(*description), {extent}, SceneTraits());
    if (!renderer) return renderer.diagnostics();
    return Display(device, std::move(*renderer), extent);
}

Status Display::draw(const Shown& left, const Shown& right, float split)
{
    const auto set = [this](const char* name, const Shown& shown) {
        const float view[] = {shown.scale, shown.offset, shown.grey ? 1.0f : 0.0f};
        return renderer_->setParam(name, view, 3);
    };
    Status status = renderer_->setParam("split", split);
    if (status) status = set("left_view", left);
    if (status) status = set("right_view", right);
    Frame frame;
    frame.textures = {{"left", left.texture}, {"right", right.texture}};
    if (status) status = renderer_->render(frame);
    if (!status) return status;
    return device_->present(renderer_->output("picture"), {0, 0, 0, extent_});
}

Status Display::resize(Extent extent)
{
    extent_ = extent;
    return renderer_->resize(extent);
}

}  // namespace crevice::page
