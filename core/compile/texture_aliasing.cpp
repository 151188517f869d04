// SPDX-License-Identifier: MIT
// Textures: sizes, formats that the device can render to, and slots that targets share.
#include "core/compile/steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice::compiler {

namespace {

std::string text(const Extent& extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

// In float on purpose: 0.1f is a little above 0.1, and in double 1000 * 0.1f would round up to 101.
int scaled(int size, float scale)
{
    constexpr float kLargest = 1e9f;  // fits an int; far over what any device takes
    const float product = static_cast<float>(size) * scale;
    return static_cast<int>(std::max(1.0f, std::ceil(std::min(product, kLargest))));
}

bool within(const Extent& extent, int limit)
{
    return extent.width <= limit && extent.height <= limit;
}

bool isDepth(const TargetDesc& target)
{
    return formatInfo(target.formats.front()).format_class == FormatClass::depth;
}

// ---- sizes

float scaleOf(const Description& description, const SizeDesc& size)
{
    const ParamDesc* param = findNamed(description.params, size.scale_param.name);
    return param ? param->value[0] : size.scale;
}

// Sizes do not follow each other in a circle: decode sees to that.
Extent followedExtent(const State& state, const SizeDesc& size)
{
    const TargetDesc* followed = findNamed(state.description.targets, size.of.name);
    const Extent extent = followed ? followedExtent(state, followed->size) : state.options.extent;
    const float scale = scaleOf(state.description, size);
    return {scaled(extent.width, scale), scaled(extent.height, scale)};
}

void checkAttachmentSizes(State& state, const Pass& pass)
{
    const std::vector<int> written = writtenBy(pass);
    for (const int index : written) {
        const Extent& first = state.targets[written.front()].extent;
        const Extent& other = state.targets[index].extent;
        if (first == other) continue;
        const auto& targets = state.description.targets;
        Diagnostic& error =
            report(state, Code::attachment_size,
                   "pass '" + pass.desc->name + "' writes targets of different sizes: '" +
                       targets[written.front()].name + "' is " + text(first) + ", '" +
                       targets[index].name + "' is " + text(other),
                   referenceTo(pass, targets[index].name));
        for (const int each : {written.front(), index})
            error.notes.push_back(
                {targets[each].size.place.source ? targets[each].size.place : targets[each].place,
                 "'" + targets[each].name + "' has its size here"});
        error.help = "give them the same `size`";
        return;
    }
}

// ---- formats

void checkKind(State& state, const Reference& at, bool depth)
{
    const TargetDesc* target = findNamed(state.description.targets, at.name);
    if (!target) return;
    for (const Format format : target->formats) {
        const FormatInfo& info = formatInfo(format);
        if ((info.format_class == FormatClass::depth) == depth) continue;
        report(state, Code::attachment_kind,
               "target '" + at.name + "' has format " + info.name + ", which cannot be a " +
                   (depth ? "depth" : "colour") + " attachment",
               at, depth ? "use depth16, depth24 or depth32f" : "use a colour format");
        return;
    }
}

void checkAttachments(State& state, const Pass& pass)
{
    for (const Reference& color : pass.desc->color) checkKind(state, color, false);
    if (!pass.desc->depth.empty()) checkKind(state, pass.desc->depth, true);
    if (!pass.desc->mask.empty()) checkKind(state, pass.desc->mask, true);
    const int limit = std::min(state.caps.max_color_attachments, kMaxColorAttachments);
    const int count = static_cast<int>(pass.desc->color.size());
    if (count <= limit) return;
    report(state, Code::too_many,
           "pass '" + pass.desc->name + "' writes " + std::to_string(count) +
               " colour targets, and the device takes " + std::to_string(limit),
           *pass.desc, "pack them into fewer targets, or split the pass");
}

void checkSubstitute(State& state, const Reference& output, const Reference& input)
{
    const TargetDesc* replaced = findNamed(state.description.targets, output.name);
    const TargetDesc* by = findNamed(state.description.targets, input.name);
    if (!replaced || !by || isDepth(*replaced) == isDepth(*by)) return;
    report(state, Code::bypass_class,
           "'" + input.name + "' (" + formatInfo(by->formats.front()).name +
               ") cannot stand in for '" + output.name + "' (" +
               formatInfo(replaced->formats.front()).name +
               "): one holds depth and the other colour",
           input, "give both targets formats of one kind");
}

std::string listed(const std::vector<Format>& formats)
{
    std::string names;
    for (const Format format : formats)
        names += (names.empty() ? "" : ", ") + std::string(formatInfo(format).name);
    return names;
}

void checkFormat(State& state, const TargetDesc& desc, Format chosen)
{
    if (!state.caps.canRender(chosen)) {
        report(state, Code::no_format,
               "the device can render to no format of target '" + desc.name +
                   "': " + listed(desc.formats),
               desc, "add a format that every device has, such as rgba8 or depth16");
        return;
    }
    if (state.caps.canRender(desc.formats.front())) return;
    Diagnostic& warning = report(
        state, Code::no_format,
        "target '" + desc.name + "' falls back from " + formatInfo(desc.formats.front()).name +
            " to " + formatInfo(chosen).name + ": the device does not render to the first choice",
        desc);
    warning.severity = Severity::warning;
}

// ---- slots

constexpr int kForever = std::numeric_limits<int>::max();

// The plan's textures, and until which pass each is busy.
class Slots {
public:
    Slots(std::vector<PlanTexture>& textures, bool share) : textures_(textures), share_(share) {}

    // A texture for no one else.
    int add(const PlanTexture& wanted, int last_pass)
    {
        textures_.push_back(wanted);
        busy_until_.push_back(last_pass);
        return static_cast<int>(textures_.size()) - 1;
    }

    // One that is free by `first_pass`, or a new one.
    int take(const PlanTexture& wanted, int first_pass, int last_pass)
    {
        const int slot =
            find(wanted, first_pass, [&](const Extent& each) { return each == wanted.extent; });
        return slot < 0 ? add(wanted, last_pass) : use(slot, wanted, last_pass);
    }

    // For what a pass draws into and nobody reads: a part of a larger one will do as well.
    int takeScratch(const PlanTexture& wanted, int pass)
    {
        const int slot = find(wanted, pass, [&](const Extent& each) {
            return each.width >= wanted.extent.width && each.height >= wanted.extent.height;
        });
        return slot < 0 ? add(wanted, pass) : use(slot, wanted, pass);
    }

private:
    template <class Fits>
    int find(const PlanTexture& wanted, int first_pass, Fits&& fits) const
    {
        for (std::size_t i = 0; share_ && i < textures_.size(); ++i) {
            const PlanTexture& each = textures_[i];
            if (busy_until_[i] < first_pass && each.format == wanted.format && fits(each.extent) &&
                each.samples == wanted.samples)
                return static_cast<int>(i);
        }
        return -1;
    }

    int use(int slot, const PlanTexture& wanted, int last_pass)
    {
        textures_[slot].targets.push_back(wanted.targets.front());
        busy_until_[slot] = last_pass;
        return slot;
    }

    std::vector<PlanTexture>& textures_;
    std::vector<int> busy_until_;
    bool share_;
};

}  // namespace

Extent sizeOf(const State& state, int target)
{
    return followedExtent(state, state.description.targets[target].size);
}

void chooseExtents(State& state)
{
    const int limit = state.caps.max_texture_size;
    const bool fits = within(state.options.extent, limit);
    if (!fits)
        report(state, Code::too_big_for_device,
               "a picture of " + text(state.options.extent) +
                   " is wanted, and the device's textures end at " + std::to_string(limit) + "x" +
                   std::to_string(limit),
               Place{}, "ask for a smaller size");
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        Target& target = state.targets[i];
        const TargetDesc& desc = state.description.targets[i];
        target.extent = sizeOf(state, static_cast<int>(i));
        if (!fits || !target.textured || within(target.extent, limit)) continue;
        const int followed = indexOf(state.description.targets, desc.size.of.name);
        const bool told = followed >= 0 && state.targets[followed].textured &&
                          !within(sizeOf(state, followed), limit);
        if (told) continue;
        report(state, Code::too_big_for_device,
               "target '" + desc.name + "' would be " + text(target.extent) +
                   ", and the device's textures end at " + std::to_string(limit) + "x" +
                   std::to_string(limit),
               desc, "use a smaller `scale`, or ask for a smaller size");
    }
    for (const Pass& pass : state.passes)
        if (pass.active) checkAttachmentSizes(state, pass);
}

void checkFormats(State& state)
{
    for (const Pass& pass : state.passes) {
        if (pass.active) checkAttachments(state, pass);
        for (const BypassDesc& bypass : pass.desc->bypass)
            checkSubstitute(state, bypass.output, bypass.input);
    }
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const Target& target = state.targets[i];
        if (target.textured) checkFormat(state, state.description.targets[i], target.format);
    }
}

void shareTextures(const State& state, Plan& plan)
{
    Slots slots(plan.textures, state.applies("aliasing"));
    for (PlanTarget& target : plan.targets) {
        const int index = indexOf(state.description.targets, target.name);
        const TargetDesc& desc = state.description.targets[index];
        const Target& found = state.targets[index];
        PlanTexture texture{found.format, found.extent, found.samples, {target.name}};
        if (found.remembered) {
            target.texture = target.drawn_texture = slots.add(texture, kForever);
            texture.targets = {historyName(desc)};
            target.history_texture = slots.add(texture, kForever);
            continue;
        }
        const bool depth = formatInfo(found.format).format_class == FormatClass::depth;
        if (depth && target.last_pass == target.first_pass) {
            target.texture = target.drawn_texture = slots.takeScratch(texture, target.first_pass);
            continue;
        }
        const bool resolved = found.samples > 1 && target.last_pass > target.first_pass;
        const int last_drawn = resolved ? target.first_pass : target.last_pass;
        target.texture = target.drawn_texture = slots.take(texture, target.first_pass, last_drawn);
        if (!resolved) continue;
        texture.samples = 1;
        target.texture = slots.take(texture, target.first_pass, target.last_pass);
    }
    for (const PlanTarget& target : plan.targets) {
        if (target.last_pass < static_cast<int>(plan.passes.size())) continue;
        plan.textures[target.texture].copies = plan.views;
        if (target.history_texture >= 0) plan.textures[target.history_texture].copies = plan.views;
    }
}

}  // namespace crevice::compiler
