// SPDX-License-Identifier: MIT
// Sizes and samples of targets. All that a pass writes has the same.
#include "core/compile/steps.h"

#include "core/base/text.h"

#include <cmath>
#include <functional>

namespace crevice::compiler {
namespace {

std::string text(const Extent& extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

std::string sizeText(const Target& target)
{
    return text(target.extent) + (target.depth > 0 ? "x" + std::to_string(target.depth) : "");
}

void checkVolume(State& state, const TargetDesc& desc, const Target& target)
{
    const int limit = state.caps.max_volume_size;
    const auto told = [](const Diagnostic& each) { return each.code == Code::too_big_for_device; };
    if (std::max({target.extent.width, target.extent.height, target.depth}) <= limit ||
        anyOf(state.diagnostics, told))  // one param may give the size of many
        return;
    report(state, Code::too_big_for_device,
           "target '" + desc.name + "' would be " + sizeText(target) +
               ", and the device's volumes end at " + std::to_string(limit) + " along an edge",
           desc, "use fewer voxels");
}

// Whether a pass draws each layer of its volumes once.
bool drawsAllLayers(State& state, const Pass& pass)
{
    if (pass.color.empty() || state.targets[pass.color.front()].depth == 0) return true;
    const int layers = state.targets[pass.color.front()].depth, at_once = layersAtOnce(pass);
    const bool alike = allOf(pass.color, [&](int each) {
        return std::count(pass.color.begin(), pass.color.end(), each) == at_once;
    });
    if (alike && layers % at_once == 0) return true;
    const std::vector<std::string> params =
        namesOf(state.description.targets[pass.color.front()].size.depth.params);
    report(state, Code::attachment_size,
           quoted(pass) + " draws " + std::to_string(at_once) + " layers of '" +
               nameOf(state, pass.color.front()) + "' at once, " +
               (alike ? "and its " + std::to_string(layers) + " are no multiple of that"
                      : "and more or fewer of another volume"),
           *pass.desc,
           alike ? "let its `depth` be a multiple of " + std::to_string(at_once) +
                       (params.empty() ? "" : ": change " + joined(params, " or "))
                 : "name each volume under `color` as often as the others");
    return false;
}

std::string endsAt(const State& state)
{
    const int limit = state.caps.max_texture_size;
    return "the device's textures end at " + text(Extent{limit, limit});
}

constexpr double kLargest = 1e9;  // fits an int; far over what any device takes

// Rounded up, but for what rounding `scale` to a float adds: 1.2f is above 1.2; 360 * 1.2 is 432.
int scaled(int size, float scale)
{
    constexpr double kEpsilon = 6.0e-8;  // 2^-24: half a step of floats, relative
    const double product = size * (scale * (1 - kEpsilon));
    return static_cast<int>(std::max(1.0, std::ceil(std::min(product, kLargest))));
}

int texels(const State& state, const ProductDesc& product)
{
    const double value = valueOf(product, state.description.params);
    return static_cast<int>(std::clamp(std::round(value), 1.0, kLargest));
}

bool within(const Extent& extent, int limit)
{
    return extent.width <= limit && extent.height <= limit;
}

// With whole pixels added on either side, rounded up but for what the rounding of `scale` adds.
// Shaders find `size` from what this returns: effects/common/guard_band.glsl.
int bordered(int size, float scale)
{
    constexpr double kEpsilon = 0.01;  // of a pixel, as there
    const double border = std::ceil(0.5 * size * (double(scale) - 1.0) - kEpsilon);
    return static_cast<int>(std::min(size + 2.0 * std::max(0.0, border), kLargest));
}

// The scale itself, or one at which the border ends where the device's textures do.
float fittingScale(int size, float scale, int limit)
{
    if (bordered(size, scale) <= limit) return scale;
    return static_cast<float>(1.0 + 2.0 * std::max(0, (limit - size) / 2) / size);
}

// As fittingScale, of all targets whose borders the param gives.
float fittingScale(const State& state, const ParamDesc& param)
{
    float scale = param.value[0];
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const SizeDesc& desc = state.description.targets[i].size;
        if (!desc.border || desc.scale_param.name != param.name) continue;
        const int followed = state.targets[i].followed;
        const Extent inner = followed >= 0 ? sizeOf(state, followed) : state.options.extent;
        for (const int size : {inner.width, inner.height})
            scale = std::min(scale, fittingScale(size, scale, state.caps.max_texture_size));
    }
    return scale;
}

// Whether `fact` is the same of all that the pass writes; else it reports the first that differs.
bool attachmentsAgree(State& state, const Pass& pass, Code code, const std::string& key,
                      const std::function<std::string(int)>& fact)
{
    const std::vector<int> written = writtenBy(pass);
    for (const int index : written) {
        const int first = written.front();
        if (fact(index) == fact(first)) continue;
        Diagnostic& error = report(
            state, code,
            quoted(pass) + " writes targets that differ in " + key + ": '" + nameOf(state, first) +
                "' " + fact(first) + ", '" + nameOf(state, index) + "' " + fact(index),
            referenceTo(pass, nameOf(state, index)), "give them the same `" + key + "`");
        for (const int each : {first, index}) {
            const TargetDesc& desc = state.description.targets[each];
            const bool sized = key == "size" && desc.size.place.source;
            error.notes.push_back(
                {sized ? desc.size.place : desc.place, "'" + desc.name + "' is here"});
        }
        return false;
    }
    return true;
}

std::string text(int samples)
{
    return std::to_string(samples) + (samples == 1 ? " sample" : " samples");
}

// The least count that is no less than was asked for, or else the most.
int nearestCount(std::uint32_t counts, int asked)
{
    const auto has = [counts](int samples) { return (counts >> (samples - 1) & 1u) != 0; };
    for (int samples = asked; samples <= kMaxSamples; ++samples)
        if (has(samples)) return samples;
    for (int samples = asked - 1; samples > 1; --samples)
        if (has(samples)) return samples;
    return 1;
}

void choose(State& state, const Pass& pass, const std::vector<int>& written)
{
    const int asked = askedSamples(state, written.front());
    if (asked == 1) return;
    std::uint32_t counts = ~0u;
    std::vector<std::string> formats;
    for (const int index : written) {
        const Target& target = state.targets[index];
        if (!target.textured) continue;
        counts &= state.caps.sample_counts[static_cast<int>(target.format)];
        formats.push_back(formatInfo(target.format).name);
    }
    const int count = nearestCount(counts, asked);
    for (const int index : written) state.targets[index].samples = count;
    if (count >= asked || !pass.live) return;
    report(state, Code::no_samples,
           quoted(pass) + " falls back from " + text(asked) + " a pixel to " +
               std::to_string(count) + ": the device draws no more into " + joined(formats),
           *pass.desc)
        .severity = Severity::warning;
}

}  // namespace

std::optional<Description> fitBorders(const State& state, std::vector<Elided>& elided)
{
    std::optional<Description> fitted;
    for (std::size_t i = 0; i < state.description.params.size(); ++i) {
        const ParamDesc& param = state.description.params[i];
        if (param.bind != Bind::define) continue;  // what a host sets does not pass by here
        const float scale = fittingScale(state, param);
        if (scale >= param.value[0] || scale < param.min) continue;
        if (!fitted) fitted = state.description;
        fitted->params[i].value[0] = scale;
        elided.push_back({"part of " + param.name, "device",
                          endsAt(state) + ", so it is " + shortest(scale) + " instead of " +
                              shortest(param.value[0])});
    }
    return fitted;
}

// Sizes do not follow each other in a circle: decode sees to that.
Extent sizeOf(const State& state, int target)
{
    std::vector<int> chain;
    for (; target >= 0; target = state.targets[target].followed) chain.push_back(target);
    Extent extent = state.options.extent;
    for (auto at = chain.rbegin(); at != chain.rend(); ++at) {
        const SizeDesc& size = state.description.targets[*at].size;
        const ParamDesc* param = findNamed(state.description.params, size.scale_param.name);
        const float scale = param ? param->value[0] : size.scale;
        const auto factor = size.border ? bordered : scaled;
        extent = {factor(extent.width, scale), factor(extent.height, scale)};
        if (size.width.factor > 0) extent = {texels(state, size.width), texels(state, size.height)};
    }
    return extent;
}

int depthOf(const State& state, int target)
{
    const TargetDesc& desc = state.description.targets[target];
    return isVolume(desc) ? texels(state, desc.size.depth) : 0;
}

int layersAtOnce(const Pass& pass)
{
    return static_cast<int>(std::count(pass.color.begin(), pass.color.end(), pass.color.front()));
}

float viewsOf(const State& state, int target)
{
    const std::vector<TargetDesc>& targets = state.description.targets;
    int sized = target;
    while (sized >= 0 && !targets[sized].size.border) sized = state.targets[sized].followed;
    if (sized < 0) return 0.0f;
    const Extent size = sizeOf(state, target);
    const Extent view = state.options.extent;
    return std::max(static_cast<float>(size.width) / static_cast<float>(view.width),
                    static_cast<float>(size.height) / static_cast<float>(view.height));
}

void chooseExtents(State& state)
{
    const int limit = state.caps.max_texture_size;
    const Extent& asked = state.options.extent;
    if (asked.width < 1 || asked.height < 1)
        report(state, Code::bad_size,
               "a size of " + text(asked) + " was asked for, and both sides must be at least 1",
               Named{}, "ask for a size such as 1920x1080");
    const bool fits = within(asked, limit);
    if (!fits)
        report(state, Code::too_big_for_device,
               "a picture of " + text(asked) + " is wanted, and " + endsAt(state), Named{},
               "ask for a smaller size");
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        Target& target = state.targets[i];
        const TargetDesc& desc = state.description.targets[i];
        target.extent = sizeOf(state, static_cast<int>(i));
        target.depth = depthOf(state, static_cast<int>(i));
        if (target.depth > 0 && target.textured) checkVolume(state, desc, target);
        if (!fits || !target.textured || within(target.extent, limit)) continue;
        const int followed = target.followed;
        const bool reported = followed >= 0 && state.targets[followed].textured &&
                              !within(sizeOf(state, followed), limit);
        if (reported) continue;
        report(
            state, Code::too_big_for_device,
            "target '" + desc.name + "' would be " + text(target.extent) + ", and " + endsAt(state),
            desc, "use a smaller `scale`, or ask for a smaller size");
    }
    const auto size = [&](int target) { return "is " + sizeText(state.targets[target]); };
    for (const Pass& pass : state.passes)
        if (pass.active && attachmentsAgree(state, pass, Code::attachment_size, "size", size) &&
            !drawsAllLayers(state, pass))
            break;  // one param may give the depth of many
}

int askedSamples(const State& state, int target)
{
    const TargetDesc& desc = state.description.targets[target];
    const ParamDesc* param = findNamed(state.description.params, desc.samples_param.name);
    return param ? static_cast<int>(param->value[0]) : desc.samples;
}

void chooseSamples(State& state)
{
    for (const Pass& pass : state.passes) {
        const std::vector<int> written = writtenBy(pass);
        if (!pass.active || written.empty()) continue;
        const auto asked = [&](int target) {
            return "has " + text(askedSamples(state, target)) + " a pixel";
        };
        if (attachmentsAgree(state, pass, Code::attachment_samples, "samples", asked))
            choose(state, pass, written);
    }
}

}  // namespace crevice::compiler
