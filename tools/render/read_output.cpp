// SPDX-License-Identifier: MIT
#include "tools/render/read_output.h"

#include "core/base/text.h"
#include "tools/commands/cli/load_config.h"

#include <crevice/shipped.h>

#include <glm/matrix.hpp>

#include <cmath>

namespace crevice {
namespace {
constexpr std::string_view kTargetPrefix = "target.";

Diagnostic unknownOutput(const Description& description, const std::string& name)
{
    std::vector<std::string> names = namesOf(description.outputs);
    for (const ViewDesc& view : description.views) names.push_back(view.name);
    for (const TargetDesc& target : description.targets)
        names.push_back(findNamed(description.outputs, target.name)
                            ? std::string(kTargetPrefix) + target.name
                            : target.name);
    return Diagnostic{
        Code::output_missing,
        "the config '" + description.name + "' has no output, view or target '" + name + "'",
        suggestName(name, std::move(names), "names")};
}

/// Exports a target under a name of its own and returns that name.
std::string exportTarget(Description& description, const std::string& target)
{
    const std::string name = std::string(kTargetPrefix) + target;
    if (!findNamed(description.outputs, name)) {
        OutputDesc output;
        output.name = name;
        output.target.name = target;
        description.outputs.push_back(std::move(output));
    }
    return name;
}

}  // namespace

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
    const Result<Description> description =
        loadDescription({kDepthModule, {}, {}, {}}, shippedSources());
    if (!description) return description.diagnostics();
    const auto renderer = Renderer::create(device, *description, {extent, {}, {}}, traitsOf(frame));
    if (!renderer) return renderer.diagnostics();
    if (const Status drawn = (*renderer)->render(frame); !drawn) return drawn.diagnostics();
    return readOutput(device, **renderer, "depth");
}

std::optional<double> medianOf(std::vector<double> values)
{
    if (values.empty()) return std::nullopt;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<double> medianDistance(const Image& depth, const Camera& camera)
{
    const float background = camera.reversedDepth() ? 0.0f : 1.0f;
    std::vector<double> seen;
    for (std::size_t i = 0; i < depth.pixels.size(); i += depth.channels)
        if (depth.pixels[i] != background) seen.push_back(depth.pixels[i]);
    const std::optional<double> middle = medianOf(std::move(seen));
    if (!middle) return std::nullopt;
    const bool zero_to_one = camera.clip_control && camera.clip_control->zero_to_one;
    const glm::dmat4 view_from_clip = glm::inverse(glm::dmat4(camera.clip_from_view));
    const glm::dvec4 view =
        view_from_clip * glm::dvec4(0, 0, zero_to_one ? *middle : *middle * 2.0 - 1.0, 1);
    return std::abs(view.z / view.w);  // a left-handed view looks along +z
}

Result<OutputSource> exposeOutput(Description& description, const std::string& name)
{
    if (findNamed(description.outputs, name)) return OutputSource{name};
    if (const ViewDesc* view = findNamed(description.views, name))
        return OutputSource{exportTarget(description, view->target.name), view->scale,
                            view->offset};
    const bool prefixed = name.rfind(kTargetPrefix, 0) == 0;
    const std::string target = prefixed ? name.substr(kTargetPrefix.size()) : name;
    const TargetDesc* const found = findNamed(description.targets, target);
    if (found && isVolume(*found))
        return Diagnostic{Code::attachment_kind,
                          "target '" + target + "' is a volume, and no picture",
                          "let a pass draw what is to be seen of it into a picture", found->place,
                          found->pointer};
    if (found) return OutputSource{exportTarget(description, target)};
    return unknownOutput(description, name);
}

void applyView(Image& image, const OutputSource& source)
{
    for (float& value : image.pixels) value = value * source.scale + source.offset;
}

Format formatOf(const Plan& plan, const std::string& target)
{
    const PlanTarget* found = findNamed(plan.targets, target);
    return found ? plan.textures[found->texture].format : Format::none;
}

std::vector<WatchedTarget> watchAll(const Plan& plan, Description& description)
{
    std::vector<WatchedTarget> watched;
    for (const PlanPass& pass : plan.passes) {
        const auto watch = [&](const PlanAttachment& attachment) {
            if (attachment.target < 0) return;
            const Result<OutputSource> source =
                exposeOutput(description, "target." + attachment.name);
            if (source) watched.push_back({attachment.name, pass.name, source->output});
        };
        for (const PlanAttachment& color : pass.color) watch(color);
        if (pass.has_depth && !isMasked(pass)) watch(pass.depth);
    }
    return watched;
}

}  // namespace crevice
