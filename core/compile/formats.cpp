// SPDX-License-Identifier: MIT
// Formats by how finely they store what surfaces are found by, and a warning where none serves.
#include "core/compile/steps.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/compile/depth_precision.h"

#include <algorithm>
#include <cmath>

namespace crevice::compiler {

namespace {

bool isDepth(Format format) { return formatInfo(format).format_class == FormatClass::depth; }

std::string figure(double value) { return significant(value, 3); }

// "resolves 6.12 at distance 20, and a tenth of the radius 0.5 up to 1.81 alone"
std::string reachText(const SceneTraits& traits, const ParamDesc& radius, const PrecisionNeed& need,
                      const StoredSurface& surface, double reach)
{
    const double step = viewStep(traits, surface, need.distance);
    return (std::isfinite(step) ? "resolves " + figure(step) + " at distance "
                                : std::string("does not hold distance ")) +
           figure(need.distance) + ", and a tenth of the " + radius.name + " " +
           shortest(radius.value[0]) +
           (reach > 0 ? " up to " + figure(reach) + " alone" : " nowhere");
}

std::string cameraText(const SceneTraits& traits)
{
    return traits.orthographic ? "its planes " + figure(traits.camera.far_distance) + " apart"
                               : "near " + figure(traits.camera.near_distance);
}

std::string helpFor(const SceneTraits& traits, const ParamDesc& radius,
                    const StoredSurface& surface)
{
    const FormatInfo& info = formatInfo(surface.format);
    const bool depth = isDepth(surface.format);
    std::string help = info.bytes < 4 * info.channels ? "store it with more bits, " : "";
    if (depth)
        help += traits.orthographic ? "bring the planes closer together, "
                                    : "move the near plane out, ";
    if (depth && !surface.drawn && !traits.reversed_depth)
        help += "take reversed depth in depth32f, ";
    return help + (help.empty() ? "" : "or ") + "raise the " + radius.name;
}

// Whether a pass that runs looks about within the radius, and allows for the steps of what `name`
// stores.
bool allowsFor(const State& state, const std::string& name)
{
    const std::string define = stepDefine(name);
    const auto is_length = [&](const PlanUniform& each) {
        return each.source == UniformSource::param &&
               state.description.params[each.index].semantic == ParamSemantic::length;
    };
    return std::any_of(state.passes.begin(), state.passes.end(), [&](const Pass& pass) {
        if (!pass.live || pass.shader < 0) return false;
        const std::vector<std::string>& used = state.shaders[pass.shader].fragment.defines_used;
        return std::count(used.begin(), used.end(), define) > 0 &&
               std::any_of(pass.uniforms.begin(), pass.uniforms.end(), is_length);
    });
}

// Of a texture, with the place at which its format is named.
void lintTexture(State& state, const PrecisionNeed& need, const StoredSurface& surface,
                 const Reference& at)
{
    if (!allowsFor(state, at.name)) return;
    const double reach = resolvedDistance(state.traits, surface, need);
    if (reach >= need.distance) return;
    const ParamDesc& radius = *resolvedLength(state.description);
    report(state, Code::too_coarse,
           std::string(formatInfo(surface.format).name) + " of '" + at.name + "'" +
               (isDepth(surface.format) ? " with " + cameraText(state.traits) : "") + " " +
               reachText(state.traits, radius, need, surface, reach),
           at, helpFor(state.traits, radius, surface))
        .severity = Severity::warning;
}

}  // namespace

void chooseFormats(State& state)
{
    const PrecisionNeed need =
        precisionNeed(state.description, state.traits, state.options.extent.height);
    for (std::size_t i = 0; i < state.targets.size(); ++i)
        state.targets[i].format = chooseFormat(state.description, state.description.targets[i],
                                               state.traits, state.caps, need);
}

void lintPrecision(State& state)
{
    const Description& description = state.description;
    const PrecisionNeed need =
        precisionNeed(description, state.traits, state.options.extent.height);
    if (hasErrors(state.diagnostics) || need.distance <= 0) return;
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = description.targets[i];
        if (state.targets[i].textured)
            lintTexture(state, need, storedSurface(description, desc, state.targets[i].format),
                        {desc.name, desc.formats_place, desc.pointer + "/format"});
    }
    for (const ImportDesc& desc : description.imports)
        if (desc.type == ImportType::texture)
            lintTexture(state, need, {Semantic::other, formatFromName(desc.format), false},
                        {desc.name, desc.place, desc.pointer});
}

}  // namespace crevice::compiler
