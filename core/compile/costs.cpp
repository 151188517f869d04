// SPDX-License-Identifier: MIT
// Estimates of bytes, and the list of what is left out with what that saves.
#include "core/compile/steps.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>

namespace crevice::compiler {

namespace {

// Bytes assumed of a texel that the description does not know: noise, materials, imports.
constexpr double kUnknownTexelBytes = 4;

double pixels(const Extent& extent) { return static_cast<double>(extent.width) * extent.height; }

void estimate(const Plan& plan, PlanPass& pass)
{
    const double count = pixels(pass.extent) * plan.views;
    const auto texel = [&plan](int target) {
        return formatInfo(plan.textures[plan.targets[target].texture].format).bytes;
    };
    for (const PlanInput& input : pass.inputs) {
        if (input.kind == InputKind::constant) continue;
        const bool known = input.kind == InputKind::target || input.kind == InputKind::history;
        pass.bytes_read += count * (known ? texel(input.index) : kUnknownTexelBytes);
    }
    const auto write = [&](const PlanAttachment& attachment) {
        if (attachment.store != StoreOp::store) return;
        const double bytes = count * texel(attachment.target);
        pass.bytes_written += bytes;
        if (pass.samples == 1) return;
        pass.bytes_written += bytes * pass.samples;  // and resolving reads them all
        pass.bytes_read += bytes * pass.samples;
    };
    for (const PlanAttachment& color : pass.color) write(color);
    if (pass.has_depth && !isMasked(pass)) write(pass.depth);
}

// Of all that the pass writes.
double texturesOf(const State& state, const Pass& pass)
{
    double bytes = 0;
    for (const int target : writtenBy(pass))
        bytes += pixels(sizeOf(state, target)) * formatInfo(state.targets[target].format).bytes;
    return bytes;
}

double bytesOf(const State& state, const Pass& pass)
{
    double texel = 0;
    for (const Read& read : pass.reads) {
        const bool target =
            read.named.kind == InputKind::target || read.named.kind == InputKind::history;
        texel +=
            target ? formatInfo(state.targets[read.named.index].format).bytes : kUnknownTexelBytes;
    }
    for (const int target : writtenBy(pass))
        texel += formatInfo(state.targets[target].format).bytes;
    return texel * pixels(extentOf(state, pass)) * state.traits.views;
}

// "ao is 1 everywhere, and so is ao_blur".
std::string constantReason(const State& state, const Pass& pass)
{
    std::string reason;
    for (const PreservesConstantDesc& each : pass.desc->preserves_constant) {
        const int output = indexOf(state.description.targets, each.output.name);
        reason += (reason.empty() ? "" : "; ") + each.sampler.name + " is " +
                  shortest(resolveTarget(state, output)->value) + " everywhere, and so is " +
                  each.output.name;
    }
    return reason;
}

// "intensity is 0, so ao is 1".
std::string substituteReason(const Pass& pass)
{
    std::string given;
    for (const NoOpDesc::Gives& gives : pass.no_op->gives)
        given += (given.empty() ? "" : ", ") + gives.output.name + " is " +
                 (gives.constant ? shortest(gives.value) : gives.input.name);
    return pass.no_op->param.name + " is " + shortest(pass.no_op->at) + ", so " + given;
}

void addElided(const State& state, const Pass& pass, std::vector<Elided>& elided)
{
    const auto add = [&](const char* optimization, const std::string& reason) {
        elided.push_back({"pass " + pass.desc->name, optimization, reason, bytesOf(state, pass),
                          texturesOf(state, pass)});
    };
    if (!pass.active)
        add("condition", pass.off_reason);
    else if (pass.no_op)
        add("no_op", substituteReason(pass));
    else if (pass.preserves_constant)
        add("no_op", constantReason(state, pass));
    else if (!pass.live)
        add("dead_pass", "no output asked for needs it");
    if (!pass.live) return;
    for (const int index : pass.color) {
        const Target& target = state.targets[index];
        if (target.textured) continue;
        const double bytes =
            pixels(target.extent) * formatInfo(target.format).bytes * state.traits.views;
        const std::string& name = state.description.targets[index].name;
        const char* reason =
            target.wanted ? "nobody reads it" : "nobody reads it, nor is it worked out";
        elided.push_back({"attachment " + name, "dead_pass", reason, bytes, bytes});
    }
}

// "ssao, filter_x and filter_y": the passes of which something holds; empty where of none.
template <class Test>
std::string passesThat(const Plan& plan, Test&& holds)
{
    std::vector<std::string> names;
    for (const PlanPass& pass : plan.passes)
        if (holds(pass)) names.push_back(pass.name);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
    return text;
}

}  // namespace

void estimateBytes(Plan& plan)
{
    for (PlanPass& pass : plan.passes) estimate(plan, pass);
    for (const PlanTexture& texture : plan.textures) plan.texture_bytes += textureBytes(texture);
}

std::vector<Elided> elidedOfFrames(const Plan& plan)
{
    std::vector<Elided> elided;
    const auto add = [&](const std::string& what, const std::string& passes,
                         const char* optimization, const char* reason) {
        if (!passes.empty()) elided.push_back({what + passes, optimization, reason, 0, 0, true});
    };
    add("pixels of ", passesThat(plan, isMasked), "depth_mask",
        "per frame, those that the mask excludes");
    add("pixels of ", passesThat(plan, [](const PlanPass& pass) { return pass.scissor; }),
        "scissor", "per frame, those outside the bounds of all draws");
    add("draws of ", passesThat(plan, [](const PlanPass& pass) { return pass.frustum_scale > 0; }),
        "frustum_culling", "per frame, those whose bounds are outside the view");
    if (!plan.reruns) add("", "passes", "cached", "per frame, those whose inputs have not changed");
    return elided;
}

Elided elidedBySharing(const Plan& plan)
{
    double own = 0;
    for (const PlanTarget& target : plan.targets) {
        const auto once = [&](int index) {
            if (index < 0) return 0.0;
            PlanTexture alone = plan.textures[index];
            alone.extent =
                plan.passes[target.first_pass].extent;  // it may have a part of a larger one
            return textureBytes(alone);
        };
        own += once(target.texture) + once(target.history_texture) +
               (target.drawn_texture == target.texture ? 0 : once(target.drawn_texture));
    }
    const std::string count = std::to_string(plan.textures.size());
    return {"textures", "aliasing", std::to_string(plan.targets.size()) + " targets share " + count,
            0, own - plan.texture_bytes};
}

std::vector<Elided> elided(const State& state)
{
    std::vector<Elided> elided;
    for (const Pass& pass : state.passes) addElided(state, pass, elided);
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = state.description.targets[i];
        const Target& target = state.targets[i];
        if (desc.history && target.textured && !target.remembered)
            elided.push_back(
                {"history " + desc.name, "dead_pass", "no pass reads " + historyName(desc), 0});
    }
    return elided;
}

}  // namespace crevice::compiler
