// SPDX-License-Identifier: MIT
#include "tools/render/read_output.h"

#include <algorithm>

namespace crevice {

bool remembers(const Plan& plan)
{
    return std::any_of(plan.targets.begin(), plan.targets.end(),
                       [](const PlanTarget& target) { return target.history_texture >= 0; });
}

Result<Image> readOutput(Device& device, const Renderer& renderer, std::string_view name, int view)
{
    Result<Image> image = device.readTexture(renderer.output(name, view));
    if (!image) return image;
    const PlanOutput* output = findNamed(renderer.plan().outputs, name);
    if (output && output->constant >= 0)
        return Image(renderer.plan().extent, 1, image->pixels.front());
    return image;
}

Result<Image> drawSettled(Device& device, Renderer& renderer, const Frame& frame,
                          std::string_view name)
{
    const int frames = remembers(renderer.plan()) ? kGatheringFrames : 1;
    for (int i = 0; i < frames; ++i)
        if (const Status drawn = renderer.render(frame); !drawn) return drawn.diagnostics();
    return readOutput(device, renderer, name);
}

}  // namespace crevice
