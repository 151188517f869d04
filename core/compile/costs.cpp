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

double pixels(const Extent& extent)
{
    return static_cast<double>(extent.width) * extent.height;
}

void estimate(const Plan& plan, PlanPass& pass)
{
    const double count = pixels(pass.extent) * plan.views;
    const auto texel = [&plan](int target) {
        return formatInfo(plan.textures[plan.targets[target].texture].format).bytes;
    };
    for (const PlanInput& input : pass.inputs) {
        if (input.kind == InputKind::constant) continue;
        const bool known =
            input.kind == InputKind::target || input.kind == InputKind::history;
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
        bytes += sizeOf(state, target).width * static_cast<double>(sizeOf(state, target).height) *
                 formatInfo(state.targets[target].format).bytes;
    return bytes;
}

double bytesOf(const State& state, const Pass& pass)
{
    double texel = 0;
    for (const Read& read : pass.reads) {
        const bool target = read.named.kind == InputKind::target ||
                            read.named.kind == InputKind::history;
        texel += target ? formatInfo(state.targets[read.named.index].format).bytes
                        : kUnknownTexelBytes;
    }
    for (const int target : writtenBy(pass))
        texel += formatInfo(state.targets[target].format).bytes;
    return texel * pixels(extentOf(state, pass)) * state.traits.views;
}

// "ao is 1 everywhere, and so is ao_blur".
std::string constantReason(const State& state, const Pass& pass)
{
    std::string reason;
    for (const KeepsConstantDesc& each : pass.desc->keeps_constant) {
        const int output = indexOf(state.description.targets, each.output.name);
        reason += (reason.empty() ? "" : "; ") + each.sampler.name + " is " +
                  shortest(resolveTarget(state, output)->value) + " everywhere, and so is " +
                  each.output.name;
    }
    return reason;
}

// "intensity is 0, so ao is 1".
std::string standInReason(const Pass& pass)
{
    std::string given;
    for (const IdentityDesc::Gives& gives : pass.identity->gives)
        given += (given.empty() ? "" : ", ") + gives.output.name + " is " +
                 (gives.constant ? shortest(gives.value) : gives.input.name);
    return pass.identity->param.name + " is " + shortest(pass.identity->at) + ", so " + given;
}

void addLeftOut(const State& state, const Pass& pass, std::vector<LeftOut>& left_out)
{
    const auto add = [&](const char* rule, const std::string& reason) {
        left_out.push_back({"pass " + pass.desc->name, rule, reason, bytesOf(state, pass),
                            texturesOf(state, pass)});
    };
    if (!pass.active) add("condition", pass.off_reason);
    else if (pass.identity) add("identity", standInReason(pass));
    else if (pass.keeps_constant) add("identity", constantReason(state, pass));
    else if (!pass.live) add("unread", "no output asked for needs it");
    if (!pass.live) return;
    for (const int index : pass.color) {
        const Target& target = state.targets[index];
        if (target.textured) continue;
        const double bytes =
            pixels(target.extent) * formatInfo(target.format).bytes * state.traits.views;
        const std::string& name = state.description.targets[index].name;
        const char* reason =
            target.wanted ? "nobody reads it" : "nobody reads it, nor is it worked out";
        left_out.push_back({"attachment " + name, "unread", reason, bytes, bytes});
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

std::vector<LeftOut> leftOutOfFrames(const Plan& plan)
{
    std::vector<LeftOut> left_out;
    const auto add = [&](const std::string& what, const std::string& passes, const char* rule,
                         const char* reason) {
        if (!passes.empty()) left_out.push_back({what + passes, rule, reason, 0, 0, -1, true});
    };
    add("pixels of ", passesThat(plan, isMasked), "background",
        "in a frame, those that their mask leaves out");
    add("pixels of ", passesThat(plan, [](const PlanPass& pass) { return pass.bounded; }), "bounds",
        "in a frame, those where the bounds of no thing lie");
    add("things of ", passesThat(plan, [](const PlanPass& pass) { return pass.draws_within > 0; }),
        "outside", "in a frame, those whose bounds lie outside of what is shown");
    if (!plan.reruns)
        add("", "passes", "unchanged", "in a frame, those whose input is that of the frame before");
    return left_out;
}

LeftOut leftOutBySharing(const Plan& plan)
{
    double own = 0;
    for (const PlanTarget& target : plan.targets) {
        const auto once = [&](int index) {
            if (index < 0) return 0.0;
            PlanTexture alone = plan.textures[index];
            alone.extent = plan.passes[target.first_pass].extent;  // it may have a part of a larger one
            return textureBytes(alone);
        };
        own += once(target.texture) + once(target.history_texture) +
               (target.drawn_texture == target.texture ? 0 : once(target.drawn_texture));
    }
    const std::string count = std::to_string(plan.textures.size());
    return {"textures", "sharing", std::to_string(plan.targets.size()) + " targets share " + count, 0,
            own - plan.texture_bytes};
}

std::vector<LeftOut> leftOut(const State& state)
{
    std::vector<LeftOut> left_out;
    for (const Pass& pass : state.passes) addLeftOut(state, pass, left_out);
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = state.description.targets[i];
        const Target& target = state.targets[i];
        if (desc.history && target.textured && !target.remembered)
            left_out.push_back({"history " + desc.name, "unread", "no pass reads " + historyName(desc),
                                0});
    }
    return left_out;
}

}  // namespace crevice::compiler
