// SPDX-License-Identifier: MIT
// Edits of descriptions.
#include "tools/measure/bench/error_parts.h"

#include "tools/measure/bench/sample.h"
#include "tools/render/device/float_device.h"

#include <algorithm>
#include <optional>

namespace crevice {
namespace {

template <class T>
T* named(std::vector<T>& all, const std::string& name)
{
    const auto found =
        std::find_if(all.begin(), all.end(), [&name](const T& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

/// What the sampler of a pass reads.
const std::string& readBy(const PassDesc& pass, const std::string& sampler)
{
    for (const InputDesc& input : pass.inputs)
        if (input.sampler.name == sampler && !input.from.empty()) return input.from.name;
    return sampler;
}

/// A pass through which occlusion goes, and from where to where.
struct Step {
    PassDesc* pass;
    std::string sampler;
    std::string from;
    std::string to;
};

std::optional<Step> stepTo(Description& description, const std::string& target)
{
    for (PassDesc& pass : description.passes)
        for (const PreservesConstantDesc& each : pass.preserves_constant)
            if (each.output.name == target)
                return Step{&pass, each.sampler.name, readBy(pass, each.sampler.name), target};
    return std::nullopt;
}

/// From the target `ao` to that of the output; empty where they are the same or no passes join
/// them.
std::vector<Step> filterSteps(Description& description, const std::string& output)
{
    std::vector<Step> steps;
    for (std::string target = output; target != kOcclusionTarget;) {
        const std::optional<Step> step = stepTo(description, target);
        if (!step || steps.size() > description.passes.size()) return {};
        target = step->from;
        steps.insert(steps.begin(), *step);
    }
    return steps;
}

double scaleOf(const Description& description, const std::string& target)
{
    const TargetDesc* found = findNamed(description.targets, target);
    if (!found) return 1.0;
    const SizeDesc& size = found->size;
    const ParamDesc* param = findNamed(description.params, size.scale_param.name);
    const double scale = param ? param->value[0] : size.scale;
    return size.of.empty() ? scale : scale * scaleOf(description, size.of.name);
}

/// Has the pass read `ao` instead, and give it where it does nothing.
void readOcclusion(const Step& step)
{
    for (NoOpDesc& no_op : step.pass->no_op)
        for (NoOpDesc::Gives& gives : no_op.gives)
            if (gives.input.name == step.from) gives.input.name = kOcclusionTarget;
    for (BypassDesc& bypass : step.pass->bypass)
        if (bypass.input.name == step.from) bypass.input.name = kOcclusionTarget;
    for (InputDesc& input : step.pass->inputs)
        if (input.sampler.name == step.sampler) {
            input.from.name = kOcclusionTarget;
            return;
        }
    InputDesc input;
    input.sampler.name = step.sampler;
    input.from.name = kOcclusionTarget;
    step.pass->inputs.push_back(std::move(input));
}

/// The widest format that can stand in for `format`.
Format wideFormat(Format format, bool filtered)
{
    const FormatInfo& info = formatInfo(format);
    if (info.format_class == FormatClass::depth) return Format::depth32f;
    if (!filtered) return floatFormat(format);
    if (info.channels == 1) return Format::r16f;
    return info.channels == 2 ? Format::rg16f : Format::rgba16f;
}

bool readLinearly(const Description& description, const TargetDesc& target)
{
    for (const PassDesc& pass : description.passes)
        for (const InputDesc& input : pass.inputs)
            if (input.has_filter && input.filter == Filter::linear &&
                (input.from.empty() ? input.sampler.name : input.from.name) == target.name)
                return true;
    return false;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& added)
{
    for (const T& each : added)
        if (!findNamed(all, each.name)) all.push_back(each);
}

/// Whether one target holds more than occlusion: what reads it cannot read `ao` instead.
bool packsMore(const Description& description, const std::string& target)
{
    const TargetDesc* packed = findNamed(description.targets, target);
    return packed && formatInfo(packed->formats.front()).channels > 1;
}

/// Has filters that pack more than occlusion give it as it comes: their shaders know UNFILTERED.
void passThrough(Description& description, const Step& step)
{
    if (ShaderDesc* shader = named(description.shaders, step.pass->shader.name))
        shader->defines["UNFILTERED"] = "1";
}

}  // namespace

void leaveOutFilter(Description& description)
{
    OutputDesc* output = named(description.outputs, kOcclusionOutput);
    if (!output) return;
    const double scale = scaleOf(description, kOcclusionTarget);
    const std::vector<Step> steps = filterSteps(description, output->target.name);
    for (const Step& step : steps) {
        if (scaleOf(description, step.to) == scale) continue;
        if (!packsMore(description, step.from)) return readOcclusion(step);
        for (const Step* before = steps.data(); before != &step; ++before)
            passThrough(description, *before);
        return;
    }
    if (findNamed(description.targets, kOcclusionTarget) &&
        scaleOf(description, output->target.name) == scale)
        output->target.name = kOcclusionTarget;
}

void takeFullSize(Description& description)
{
    TargetDesc* target = named(description.targets, kOcclusionTarget);
    while (target && !target->size.of.empty())
        target = named(description.targets, target->size.of.name);
    if (!target) return;
    if (ParamDesc* param = named(description.params, target->size.scale_param.name))
        param->value[0] = 1.0f;
    else
        target->size.scale = 1.0f;
}

bool takeGuardBand(Description& description)
{
    ParamDesc* param = named(description.params, "guard_band");
    if (param) param->value[0] = static_cast<float>(param->max);
    return param != nullptr;
}

void layOver(Description& description, const Description& added)
{
    for (const ParamDesc& param : added.params)
        if (ParamDesc* own = named(description.params, param.name)) own->value = param.value;
    for (const FeatureDesc& feature : added.features)
        if (FeatureDesc* own = named(description.features, feature.name))
            own->value = feature.value;
    append(description.features, added.features);
    for (const TargetDesc& target : added.targets)
        if (!findNamed(description.imports, target.name)) append(description.targets, {target});
    append(description.imports, added.imports);
    append(description.shaders, added.shaders);
    append(description.passes, added.passes);
    description.files.insert(added.files.begin(), added.files.end());
}

void widenFormats(Description& description, const DeviceCaps& caps)
{
    for (TargetDesc& target : description.targets) {
        const Format wide = wideFormat(target.formats.front(), readLinearly(description, target));
        if (caps.canRender(wide)) target.formats.insert(target.formats.begin(), wide);
    }
}

}  // namespace crevice
