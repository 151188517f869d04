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
    const auto found =
        std::find_if(pass.uniforms.begin(), pass.uniforms.end(),
                     [](const PlanUniform& each) { return each.source == UniformSource::kernel; });
    return found == pass.uniforms.end() ? nullptr : &*found;
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
        if (std::count(used.begin(), used.end(), define) > 0 &&
            std::any_of(pass.uniforms.begin(), pass.uniforms.end(), is_length))
            reader = &pass;
    }
    return reader;
}

// Whether the depth test of what such a shader reads goes by this target.
bool hidesWhatIsRead(const State& state, int target)
{
    return std::any_of(state.passes.begin(), state.passes.end(), [&](const Pass& pass) {
        return pass.live && pass.depth == target &&
               std::any_of(pass.color.begin(), pass.color.end(), [&](int color) {
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

// What may be found wrong of a radius, and what it depends on.
struct Lint {
    State& state;
    const ParamDesc& radius;
    bool marched = false;  // A pass marches over the screen, as far as the radius reaches.
    bool probed = false;   // A pass compares the offsets of a kernel.

    // Of a texture, with the place at which its format is named.
    void checkTexture(StoredSurface surface, const Reference& at);
    void checkVertices() const;
};

void Lint::checkTexture(StoredSurface surface, const Reference& at)
{
    const Pass* const reader = readerOf(state, at.name);
    if (reader) (kernelOf(*reader) ? probed : marched) = true;
    surface.hidden = !reader;
    const double share = unseenShare(state, at.name, reader);
    const PrecisionNeed need = needOfDraws(
        state.traits, precisionNeed(state.description, state.traits, state.options.extent.height),
        radius.value[0], share);
    const double reach = resolvedDistance(state.traits, surface, need);
    if (!(share > 0) || reach >= need.distance) return;
    const double step = viewStep(state.traits, surface, need.distance);
    report(state, Code::too_coarse,
           std::string(formatInfo(surface.format).name) + " of '" + at.name +
               (std::isfinite(step) ? "' resolves " + figure(step) + " at distance "
                                    : "' does not hold distance ") +
               figure(need.distance) + ", and " + valueOf(radius) + " wants " + figure(need.step) +
               (reach > 0 ? ", as it has up to " + figure(reach) : ""),
           at, kPrecisionHelp)
        .severity = Severity::warning;
}

void Lint::checkVertices() const
{
    const double step = state.traits.draws.vertex_step;
    const double unseen = radius.value[0] * kUnseenVertex;
    if ((!marched && !probed) || step <= unseen) return;
    report(state, Code::too_coarse,
           "vertices are rounded to " + figure(step) + " at their largest coordinates, and " +
               valueOf(radius) + " wants " + figure(unseen),
           radius,
           "move the mesh to its own origin, and place it by world_from_model, which is in double")
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
    const ParamDesc* const radius = resolvedLength(description);
    if (hasErrors(state.diagnostics) || !radius ||
        precisionNeed(description, state.traits, state.options.extent.height).distance <= 0)
        return;
    Lint lint{state, *radius};
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = description.targets[i];
        if (state.targets[i].textured)
            lint.checkTexture(storedSurface(description, desc, state.targets[i].format),
                              {desc.name, desc.formats_place, desc.pointer + "/format"});
    }
    for (const ImportDesc& desc : description.imports)
        if (desc.type == ImportType::texture)
            lint.checkTexture({Semantic::other, formatFromName(desc.format), false, false},
                              {desc.name, desc.place, desc.pointer});
    lint.checkVertices();
}

}  // namespace crevice::compiler
