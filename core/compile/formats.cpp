// SPDX-License-Identifier: MIT
// Formats by how finely they store surfaces, and whether the device and the passes can use them.
#include "core/compile/steps.h"

#include "core/base/text.h"
#include "core/plan/depth_precision.h"

#include <cmath>

namespace crevice::compiler {
namespace {

std::string figure(double value) { return significant(value, 3); }

std::string valueOf(const ParamDesc& radius)
{
    return "the " + radius.name + " " + shortest(radius.value[0]);
}

constexpr const char* kPrecisionHelp =
    "store it with more bits, of a host's depth as reversed depth in depth32f; move the near plane "
    "out, or raise the radius";

const PlanUniform* kernelOf(const Pass& pass)
{
    for (const PlanUniform& each : pass.uniforms)
        if (each.source == UniformSource::kernel) return &each;
    return nullptr;
}

// A pass that runs, looks about within the radius and allows for the steps of what `name` stores;
// one that has a kernel before others, among which filters are. Null where there is none.
const Pass* readerOf(const State& state, const std::string& name)
{
    const std::string define = stepDefine(name);
    const auto is_length = [&](const PlanUniform& each) {
        return each.source == UniformSource::param &&
               state.description.params[each.index].semantic == ParamSemantic::length;
    };
    const Pass* reader = nullptr;
    for (const Pass& pass : state.passes) {
        if (!pass.live || pass.shader < 0 || (reader && !kernelOf(pass))) continue;
        const std::vector<std::string>& used = state.shaders[pass.shader].fragment.defines_used;
        if (contains(used, define) && anyOf(pass.uniforms, is_length)) reader = &pass;
    }
    return reader;
}

// Whether the depth test of what such a shader reads goes by this target.
bool hidesWhatIsRead(const State& state, int target)
{
    return anyOf(state.passes, [&](const Pass& pass) {
        return pass.live && pass.depth == target && anyOf(pass.color, [&](int color) {
                   return color >= 0 && readerOf(state, nameOf(state, color));
               });
    });
}

// Steps in radii that are unseen of what the offsets of a kernel are compared with.
double unseenProbed(const State& state, const Pass& pass, const PlanUniform& kernel)
{
    if (state.description.generated[kernel.index].generator != "hemisphere_kernel")
        return kUnseenAround;
    double unseen = kUnseenProbed;
    for (const PlanUniform& each : pass.uniforms) {
        if (each.source != UniformSource::param) continue;
        const ParamDesc& param = state.description.params[each.index];
        if (param.semantic == ParamSemantic::margin)
            unseen = std::max(unseen, double{param.value[0]});
    }
    return unseen;
}

// The same of a texture, which `reader` reads or nobody.
double unseenShare(const State& state, const std::string& name, const Pass* reader)
{
    if (reader) {
        if (const PlanUniform* kernel = kernelOf(*reader))
            return unseenProbed(state, *reader, *kernel);
        return kUnseenMarched;
    }
    if (!(state.traits.draws.distance > 0)) return 0;
    const int target = indexOf(state.description.targets, name);
    return target >= 0 && hidesWhatIsRead(state, target) ? kUnseenHidden : 0;
}

// Of a texture, with the place at which its format is named. Whether a pass looks about in it.
bool checkTexture(State& state, const ParamDesc& radius, PrecisionNeed need, StoredSurface surface,
                  const Reference& at)
{
    const Pass* const reader = readerOf(state, at.name);
    surface.hidden = !reader;
    const double share = unseenShare(state, at.name, reader);
    if (const double distance = state.traits.draws.distance; distance > 0)
        need = {radius.value[0] * share, std::min(need.distance, distance)};
    const double reach = resolvedDistance(state.traits, surface, need);
    if (!(share > 0) || reach >= need.distance) return reader != nullptr;
    const double step = viewStep(state.traits, surface, need.distance);
    report(state, Code::too_coarse,
           std::string(formatInfo(surface.format).name) + " of '" + at.name +
               (std::isfinite(step) ? "' resolves " + figure(step) + " at distance "
                                    : "' does not hold distance ") +
               figure(need.distance) + ", and " + valueOf(radius) + " wants " + figure(need.step) +
               (reach > 0 ? ", as it has up to " + figure(reach) : ""),
           at, kPrecisionHelp)
        .severity = Severity::warning;
    return reader != nullptr;
}

void checkVertices(State& state, const ParamDesc& radius)
{
    const double step = state.traits.draws.vertex_step;
    // A point and what occludes it round as both ends of a kernel do, and triangles tilt.
    const double unseen = radius.value[0] * kUnseenProbed / 2;
    if (step <= unseen) return;
    report(state, Code::too_coarse,
           "vertices are rounded to " + figure(step) + " at their largest coordinates, and " +
               valueOf(radius) + " wants " + figure(unseen),
           radius,
           "move the mesh to its own origin, and place it by world_from_model, which is in double")
        .severity = Severity::warning;
}

void checkAttachments(State& state, const Pass& pass)
{
    const int limit = std::min(state.caps.max_color_attachments, kMaxColorAttachments);
    const int count = static_cast<int>(pass.color.size());
    if (count <= limit) return;
    report(state, Code::too_many,
           quoted(pass) + " writes " + std::to_string(count) +
               " colour targets, and the device takes " + std::to_string(limit),
           *pass.desc, "pack them into fewer targets, or split the pass");
}

void checkBlending(State& state, const Pass& pass)
{
    for (const int target : pass.color) {
        const FormatInfo& format = formatInfo(state.targets[target].format);
        if (pass.desc->state.blend == Blend::none || !state.targets[target].textured ||
            format.filterable)
            continue;
        report(state, Code::cannot_filter,
               quoted(pass) + " blends, and " + format.name + " of target '" +
                   nameOf(state, target) + "' cannot be blended",
               *pass.desc, "give the target a format of at most 16 bits a channel");
    }
}

void checkSampling(State& state, const Pass& pass)
{
    for (const Read& read : pass.reads) {
        const Reference& at = read.input ? *read.input : pass.desc->shader;
        const Filter filter = samplingOf(state, read).filter;
        if (filter == Filter::nearest) continue;
        const std::optional<Source> source = resolve(state, read.named);
        const bool mips = filter == Filter::trilinear;
        const bool target = source && source->isTarget();
        if (mips && !(target && state.description.targets[source->index].mips))
            report(state, Code::cannot_filter,
                   quoted(pass) + " reads '" + read.name +
                       "' with the filter trilinear, and it has no "
                       "mips",
                   at, "give its target \"mips\": true, or read it with the filter linear");
        if (!target) continue;
        const FormatInfo& format = formatInfo(state.targets[source->index].format);
        if (format.filterable) continue;
        report(state, Code::cannot_filter,
               quoted(pass) + " reads '" + read.name + "' with a filter, and " + format.name +
                   " of target '" + nameOf(state, source->index) +
                   "' cannot be filtered: it would read as black",
               at,
               "read it with the filter nearest, or give the target a format that filters: r8, "
               "r16f, rgba8, rgba16f");
    }
}

void checkSubstitute(State& state, const Reference& output, const Reference& input)
{
    const TargetDesc* replaced = findNamed(state.description.targets, output.name);
    const TargetDesc* by = findNamed(state.description.targets, input.name);
    if (!replaced || !by) return;
    const FormatInfo& wanted = formatInfo(replaced->formats.front());
    const FormatInfo& given = formatInfo(by->formats.front());
    if ((wanted.format_class == FormatClass::depth) == (given.format_class == FormatClass::depth))
        return;
    report(state, Code::bypass_class,
           "'" + input.name + "' (" + given.name + ") cannot stand in for '" + output.name + "' (" +
               wanted.name + "): one holds depth and the other colour",
           input, "give both targets formats of one kind");
}

void checkFormat(State& state, const TargetDesc& desc, Format chosen)
{
    if (state.caps.canRender(desc.formats.front())) return;
    if (!state.caps.canRender(chosen)) {
        std::vector<std::string> names;
        for (const Format format : desc.formats) names.push_back(formatInfo(format).name);
        report(state, Code::no_format,
               "the device can render to no format of target '" + desc.name + "': " + joined(names),
               desc, "add a format that every device has, such as rgba8 or depth16");
        return;
    }
    report(state, Code::no_format,
           "target '" + desc.name + "' falls back from " + formatInfo(desc.formats.front()).name +
               " to " + formatInfo(chosen).name +
               ": the device does not render to the first choice",
           desc)
        .severity = Severity::warning;
}

}  // namespace

void chooseFormats(State& state)
{
    for (std::size_t i = 0; i < state.targets.size(); ++i)
        state.targets[i].format =
            chooseFormat(state.description, state.description.targets[i], state.traits, state.caps,
                         state.options.extent.height);
}

void checkFormats(State& state)
{
    for (const Pass& pass : state.passes) {
        if (pass.active) checkAttachments(state, pass);
        if (pass.live) checkSampling(state, pass), checkBlending(state, pass);
        for (const BypassDesc& bypass : pass.desc->bypass)
            checkSubstitute(state, bypass, bypass.input);
    }
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const Target& target = state.targets[i];
        if (target.textured) checkFormat(state, state.description.targets[i], target.format);
    }
}

void lintPrecision(State& state)
{
    const Description& description = state.description;
    const ParamDesc* const radius = resolvedLength(description);
    const PrecisionNeed need =
        precisionNeed(description, state.traits, state.options.extent.height);
    if (hasErrors(state.diagnostics) || need.distance <= 0) return;
    bool read = false;
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = description.targets[i];
        if (state.targets[i].textured)
            read |= checkTexture(state, *radius, need,
                                 storedSurface(description, desc, state.targets[i].format),
                                 {{desc.name, desc.formats_place, desc.pointer + "/format"}});
    }
    for (const ImportDesc& desc : description.imports)
        if (desc.type == ImportType::texture)
            read |=
                checkTexture(state, *radius, need,
                             {Semantic::other, formatFromName(desc.format), false, false}, {desc});
    if (read) checkVertices(state, *radius);
}

}  // namespace crevice::compiler
