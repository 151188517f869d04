// SPDX-License-Identifier: MIT
#include "tools/measure/bench/drawn.h"

#include "core/base/text.h"
#include "tools/render/scene/camera_framing.h"

namespace crevice {

Camera BenchView::matrices() const
{
    return {camera.view_from_world, clipFromView(camera, extent, bounds)};
}

bool isPresetConfig(std::string_view config)
{
    return contains({"mobile_low", "mobile", "balanced", "high"}, config);
}

Status Drawn::prepare(Device& device, const Description& description, const Frame& scene,
                      const CompileOptions& options)
{
    Result<HostTextures> handed = HostTextures::make(device, description, options.extent, scene);
    if (!handed) return handed.diagnostics();
    host.emplace(std::move(*handed));
    if (const Status handed_over = handOver(scene); !handed_over) return handed_over;
    if (renderer) return renderer->resize(options.extent);
    auto made = Renderer::create(device, description, options, traitsOf(frame));
    if (!made) return made.diagnostics();
    renderer = std::move(*made);
    return {};
}

Status Drawn::handOver(const Frame& scene)
{
    Result<Frame> hosted = host->frameOf(scene);
    if (hosted) frame = std::move(*hosted);
    return hosted.diagnostics();
}

void Drawn::rest()
{
    host.reset();
    frame = {};
    if (renderer && !renderer->resize({1, 1})) renderer.reset();
}

}  // namespace crevice
