// SPDX-License-Identifier: MIT
// Reading outputs back.
#include "tools/read_output.h"

namespace crevice {

Result<Image> readOutput(Device& device, const Renderer& renderer, std::string_view name, int view)
{
    Result<Image> image = device.readTexture(renderer.output(name, view));
    if (!image) return image;
    const PlanOutput* output = findNamed(renderer.plan().outputs, name);
    if (output && output->constant >= 0)
        return Image(renderer.plan().extent, 1, image->pixels.front());
    return image;
}

}  // namespace crevice
