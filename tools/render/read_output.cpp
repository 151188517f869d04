// SPDX-License-Identifier: MIT
#include "tools/render/read_output.h"

#include "core/base/text.h"

#include <crevice/shipped.h>

#include <glm/matrix.hpp>

#include <cmath>

namespace crevice {

bool remembers(const Plan& plan)
{
    return anyOf(plan.targets,
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

Result<Image> drawDepth(Device& device, Frame frame, Extent extent)
{
    frame.other_views.clear();
    const Result<Node> document = loadConfig(shippedSources(), {kDepthModule});
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, shippedSources());
    if (!description) return description.diagnostics();
    const auto renderer = Renderer::create(device, *description, {extent, {}, {}}, traitsOf(frame));
    if (!renderer) return renderer.diagnostics();
    if (const Status drawn = (*renderer)->render(frame); !drawn) return drawn.diagnostics();
    return readOutput(device, **renderer, "depth");
}

std::optional<double> medianDistance(const Image& depth, const Camera& camera)
{
    std::vector<float> seen;
    for (std::size_t i = 0; i < depth.pixels.size(); i += depth.channels)
        if (depth.pixels[i] < 1.0f) seen.push_back(depth.pixels[i]);
    if (seen.empty()) return std::nullopt;
    const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::nth_element(seen.begin(), middle, seen.end());
    const glm::dmat4 view_from_clip = glm::inverse(glm::dmat4(camera.clip_from_view));
    const glm::dvec4 view = view_from_clip * glm::dvec4(0, 0, *middle * 2.0 - 1.0, 1);
    return std::abs(view.z / view.w);  // a left-handed view looks along +z
}

}  // namespace crevice
