// SPDX-License-Identifier: MIT

#include "tools/show/plan/print.h"

namespace crevice {
namespace {

// Bytes assumed of a texel that the plan does not know: noise, materials, imports.
constexpr double kUnknownTexelBytes = 4;

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

// What targets would take beyond the plan's textures if each had its own.
double sharedBytes(const Plan& plan)
{
    double own = 0;
    for (const PlanTarget& target : plan.targets) {
        const auto add = [&](int index) {
            if (index < 0) return;
            PlanTexture alone = plan.textures[index];
            alone.extent = plan.passes[target.first_pass].extent;  // it may have a part of a larger
            own += textureBytes(alone);
        };
        add(target.texture);
        add(target.history_texture);
        if (target.drawn_texture != target.texture) add(target.drawn_texture);
    }
    return own - plan.texture_bytes;
}

constexpr const char* kIntensity = "intensity";

}  // namespace

MovedBytes movedBytes(const Plan& plan, const PlanPass& pass)
{
    MovedBytes bytes;
    const double count = double(pass.extent.width) * pass.extent.height *
                         std::max(pass.layers / pass.layers_at_once, 1) *
                         (pass.box < 0 ? plan.views : 1);
    const auto texels = [&](int target) {
        return count * formatInfo(textureOf(plan, target).format).bytes;
    };
    for (const PlanInput& input : pass.inputs) {
        if (input.kind == InputKind::constant) continue;
        const bool known = input.kind == InputKind::target || input.kind == InputKind::history;
        const double read = known ? texels(input.index) : count * kUnknownTexelBytes;
        bytes.read += read;
        if (input.name.empty()) bytes.loaded += read;
    }
    const auto write = [&](const PlanAttachment& attachment) {
        if (attachment.store != StoreOp::store) return;
        bytes.written += texels(attachment.target);
        if (pass.samples == 1) return;
        bytes.written += texels(attachment.target) * pass.samples;  // and resolving reads them all
        bytes.read += texels(attachment.target) * pass.samples;
    };
    for (const PlanAttachment& color : pass.color) write(color);
    if (pass.has_depth && !isMasked(pass)) write(pass.depth);
    return bytes;
}

MovedBytes movedBytes(const Plan& plan)
{
    MovedBytes total;
    for (const PlanPass& pass : plan.passes) {
        if (pass.box >= 0) continue;  // a frame in which nothing moves draws none of it
        const MovedBytes bytes = movedBytes(plan, pass);
        total.read += bytes.read;
        total.loaded += bytes.loaded;
        total.written += bytes.written;
    }
    return total;
}

std::size_t textureCount(const Plan& plan)
{
    std::size_t count = 0;
    for (const PlanTexture& texture : plan.textures) count += texture.copies;
    return count;
}

std::vector<Elided> allElided(const Plan& plan)
{
    std::vector<Elided> elided = plan.elided;
    const auto add = [&](const std::string& what, const std::string& passes,
                         const char* optimization, const char* reason) {
        if (!passes.empty()) elided.push_back({what + passes, optimization, reason});
    };
    if (const double bytes = sharedBytes(plan); bytes > 0)
        elided.push_back({"textures", "aliasing",
                          std::to_string(plan.targets.size()) + " targets share " +
                              std::to_string(plan.textures.size()) + ", which saves " +
                              bytesText(bytes)});
    const auto masked = [](const PlanPass& pass) { return isMasked(pass) && pass.over < 0; };
    add("pixels of ", passesThat(plan, masked), "depth_mask",
        "per frame, those that the mask excludes");
    add("pixels of ", passesThat(plan, [](const PlanPass& pass) { return pass.scissor; }),
        "scissor", "per frame, those outside the bounds of all draws");
    add("draws of ", passesThat(plan, [](const PlanPass& pass) { return pass.frustum_scale > 0; }),
        "frustum_culling", "per frame, those whose bounds are outside the view");
    if (!plan.reruns) add("", "passes", "cached", "per frame, those whose inputs have not changed");
    return elided;
}

Description withoutOcclusion(Description description)
{
    for (ParamDesc& param : description.params)
        if (param.name == kIntensity) param.value.fill(0);
    return description;
}

Result<std::vector<bool>> ownGeometry(const Plan& plan, const Description& description,
                                      const SceneTraits& traits, const DeviceCaps& caps,
                                      CompileOptions options)
{
    options.outputs.clear();
    const Result<Plan> without = compile(withoutOcclusion(description), traits, caps, options);
    if (!without) return without.diagnostics();
    std::vector<bool> own;
    for (const PlanPass& pass : plan.passes)
        own.push_back(pass.type == PassType::draw && !findNamed(without->passes, pass.name));
    return own;
}

}  // namespace crevice
