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

double nearest(double x) { return std::round(x); }
double up(double x) { return std::ceil(x - 1e-9); }
double down(double x) { return std::floor(x + 1e-9); }

// To two digits, which is what a prediction is good for; up or down where a limit must hold.
std::string figure(double value, double (*rounded)(double) = nearest, int digits = 2)
{
    if (!(value > 0) || !std::isfinite(value)) return shortest(static_cast<float>(value));
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
    return shortest(static_cast<float>(rounded(value / unit) * unit));
}

// A texture whose steps some shader allows for.
struct Stored {
    std::string name;
    StoredSurface surface;
    Place place;
    std::string pointer;
    const TargetDesc* target = nullptr;  // null for an import
};

// The same scene with what a help might change.
struct Setup {
    SceneTraits traits;
    double radius;
    int height;
    std::string name;  // of the param that has the radius

    PrecisionNeed need() const { return precisionNeed(traits, radius, height); }
    double reach(const StoredSurface& surface) const
    {
        return resolvedDistance(traits, surface, need());
    }
    bool serves(const StoredSurface& surface) const
    {
        const PrecisionNeed asked = need();
        return asked.distance > 0 && reach(surface) >= asked.distance;
    }
};

Setup setupOf(const State& state)
{
    const ParamDesc* length = resolvedLength(state.description);
    return {state.traits, length ? double{length->value[0]} : 0.0, state.options.extent.height,
            length ? length->name : ""};
}

bool isDepth(Format format) { return formatInfo(format).format_class == FormatClass::depth; }

// "resolves 6.1 at distance 20, and a tenth of the radius 0.5 up to 1.8 alone"
std::string reachText(const Setup& setup, const StoredSurface& surface)
{
    const PrecisionNeed need = setup.need();
    const double step = viewStep(setup.traits, surface, need.distance);
    const double reach = setup.reach(surface);
    const std::string radius = shortest(static_cast<float>(setup.radius));
    return (std::isfinite(step) ? "resolves " + figure(step) + " at distance "
                                : std::string("does not hold distance ")) +
           figure(need.distance) + ", and a tenth of the " + setup.name + " " + radius +
           (reach > 0 ? " up to " + figure(reach, down) + " alone" : " nowhere");
}

std::string cameraText(const SceneTraits& traits)
{
    return traits.orthographic ? "its planes " + figure(traits.camera.far_distance) + " apart"
                               : "near " + figure(traits.camera.near_distance, nearest, 3);
}

// ---- what would help

// A near plane that does.
std::string nearHelp(Setup setup, const StoredSurface& surface)
{
    const PrecisionNeed need = setup.need();
    CameraRange& camera = setup.traits.camera;
    if (!isDepth(surface.format) || setup.traits.orthographic) return {};
    const double slope = 1 / camera.near_distance - 1 / camera.far_distance;
    const double share = need.step / viewStep(setup.traits, surface, need.distance);
    camera.near_distance = 1 / (slope * share + 1 / camera.far_distance) * 1.01;
    return setup.serves(surface) ? "move the near plane out to " + figure(camera.near_distance, up)
                                 : "";
}

std::string formatHelp(const State& state, const Setup& setup, const Stored& stored)
{
    const FormatInfo& now = formatInfo(stored.surface.format);
    for (const FormatInfo& info : allFormats()) {
        StoredSurface other = stored.surface;
        other.format = info.format;
        if (info.format_class != now.format_class || info.channels < now.channels ||
            (stored.target && !state.caps.canRender(info.format)) || !setup.serves(other))
            continue;
        return std::string("store it in ") + info.name;
    }
    StoredSurface reversed = stored.surface;
    reversed.format = Format::depth32f;
    Setup turned = setup;
    turned.traits.reversed_depth = true;
    const bool turns =
        !stored.surface.drawn && !setup.traits.reversed_depth && turned.serves(reversed);
    if (!turns) return {};
    return stored.target ? "give the camera reversed depth"
                         : "reverse the depth and store it in depth32f, with clip depths of 0..1";
}

std::string radiusHelp(Setup setup, const StoredSurface& surface)
{
    setup.radius = viewStep(setup.traits, surface, setup.need().distance) / kResolvedShare * 1.01;
    return std::isfinite(setup.radius) && setup.serves(surface)
               ? "raise the " + setup.name + " to " + figure(setup.radius, up)
               : "";
}

std::string helpFor(const State& state, const Setup& setup, const Stored& stored)
{
    std::vector<std::string> ways = {formatHelp(state, setup, stored),
                                     nearHelp(setup, stored.surface),
                                     radiusHelp(setup, stored.surface)};
    ways.erase(std::remove(ways.begin(), ways.end(), ""), ways.end());
    std::string text;
    for (std::size_t i = 0; i < ways.size(); ++i)
        text += (i == 0 ? "" : i + 1 < ways.size() ? ", " : ", or ") + ways[i];
    return text.empty() ? "bring the far plane nearer" : text;
}

// ---- what is stored

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

std::vector<Stored> storedSurfaces(const State& state)
{
    std::vector<Stored> all;
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = state.description.targets[i];
        if (state.targets[i].textured)
            all.push_back({desc.name,
                           storedSurface(state.description, desc, state.targets[i].format),
                           desc.formats_place, desc.pointer + "/format", &desc});
    }
    for (const ImportDesc& desc : state.description.imports)
        if (desc.type == ImportType::texture)
            all.push_back({desc.name,
                           {Semantic::other, formatFromName(desc.format), false},
                           desc.place,
                           desc.pointer});
    all.erase(std::remove_if(all.begin(), all.end(),
                             [&](const Stored& each) { return !allowsFor(state, each.name); }),
              all.end());
    return all;
}

Format preferredFormat(const State& state, const TargetDesc& target)
{
    for (const Format format : target.formats)
        if (state.caps.canRender(format)) return format;
    return target.formats.front();
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

std::string formatReason(const State& state, int target)
{
    const TargetDesc& desc = state.description.targets[target];
    const Format preferred = preferredFormat(state, desc);
    const Format chosen = state.targets[target].format;
    if (chosen == preferred) return {};
    return std::string(formatInfo(chosen).name) + " instead of " + formatInfo(preferred).name +
           ", which " +
           reachText(setupOf(state), storedSurface(state.description, desc, preferred));
}

void lintPrecision(State& state)
{
    const Setup setup = setupOf(state);
    if (hasErrors(state.diagnostics) || setup.need().distance <= 0) return;
    for (const Stored& stored : storedSurfaces(state)) {
        if (setup.serves(stored.surface)) continue;
        const Format format = stored.surface.format;
        state.diagnostics.push_back(
            {Code::too_coarse,
             std::string(formatInfo(format).name) + " of '" + stored.name + "'" +
                 (isDepth(format) ? " with " + cameraText(setup.traits) : "") + " " +
                 reachText(setup, stored.surface),
             "", stored.place, stored.pointer});
        state.diagnostics.back().severity = Severity::warning;
        state.diagnostics.back().help = helpFor(state, setup, stored);
    }
}

}  // namespace crevice::compiler
