// SPDX-License-Identifier: MIT
// Sizes and samples of targets. All that a pass writes has the same.
#include "core/compile/steps.h"

#include "core/base/text.h"

#include <functional>

namespace crevice::compiler {
namespace {

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

bool within(const Extent& extent, int limit)
{
    return extent.width <= limit && extent.height <= limit;
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

void choose(State& state, const Pass& pass, const std::vector<int>& written)
{
    const int asked = askedSamples(state.description, written.front());
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

int layersAtOnce(const Pass& pass)
{
    return static_cast<int>(std::count(pass.color.begin(), pass.color.end(), pass.color.front()));
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
               "a picture of " + text(asked) + " is wanted, and " + endsAt(state.caps), Named{},
               "ask for a smaller size");
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        Target& target = state.targets[i];
        const TargetDesc& desc = state.description.targets[i];
        target.extent = state.sizes.of(static_cast<int>(i));
        target.depth = depthOf(state.description, static_cast<int>(i));
        if (target.depth > 0 && target.textured) checkVolume(state, desc, target);
        if (!fits || !target.textured || within(target.extent, limit)) continue;
        const int followed = state.sizes.followed(static_cast<int>(i));
        const bool reported = followed >= 0 && state.targets[followed].textured &&
                              !within(state.sizes.of(followed), limit);
        if (reported) continue;
        report(state, Code::too_big_for_device,
               "target '" + desc.name + "' would be " + text(target.extent) + ", and " +
                   endsAt(state.caps),
               desc, "use a smaller `scale`, or ask for a smaller size");
    }
    const auto size = [&](int target) { return "is " + sizeText(state.targets[target]); };
    for (const Pass& pass : state.passes)
        if (pass.active && attachmentsAgree(state, pass, Code::attachment_size, "size", size) &&
            !drawsAllLayers(state, pass))
            break;  // one param may give the depth of many
}

void chooseSamples(State& state)
{
    for (const Pass& pass : state.passes) {
        const std::vector<int> written = writtenBy(pass);
        if (!pass.active || written.empty()) continue;
        const auto asked = [&](int target) {
            return "has " + text(askedSamples(state.description, target)) + " a pixel";
        };
        if (attachmentsAgree(state, pass, Code::attachment_samples, "samples", asked))
            choose(state, pass, written);
    }
}

}  // namespace crevice::compiler
