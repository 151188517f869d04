// SPDX-License-Identifier: MIT
#include "tools/render/output_source.h"

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

Result<OutputSource> exposeOutput(Description& description, const std::string& name)
{
    if (findNamed(description.outputs, name)) return OutputSource{name};
    if (const ViewDesc* view = findNamed(description.views, name))
        return OutputSource{exportTarget(description, view->target.name), view->scale,
                            view->offset};
    const bool prefixed = name.rfind(kTargetPrefix, 0) == 0;
    const std::string target = prefixed ? name.substr(kTargetPrefix.size()) : name;
    if (findNamed(description.targets, target))
        return OutputSource{exportTarget(description, target)};
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
