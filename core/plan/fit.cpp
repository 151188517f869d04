// SPDX-License-Identifier: MIT
// The part of a plan that depends on size, formats, params and views: targets and their textures.
#include "core/plan/sizes.h"

#include "core/base/text.h"
#include "core/config/values.h"
#include "core/plan/depth_precision.h"

namespace crevice {
namespace {

// The plan's textures, and until which pass each is busy.
struct Slots {
    std::vector<PlanTexture>& textures;
    bool share;
    std::vector<int> busy_until = {};

    // One that is free by `first_pass`, or a new one: before pass 0 none is free. For what no pass
    // reads, a part of a larger one will do as well, on devices that take it.
    int take(const PlanTexture& wanted, int first_pass, int last_pass, bool part)
    {
        for (std::size_t i = 0; share && i < textures.size(); ++i) {
            PlanTexture& each = textures[i];
            const bool fits = part ? each.extent.width >= wanted.extent.width &&
                                         each.extent.height >= wanted.extent.height
                                   : each.extent == wanted.extent;
            if (!fits || busy_until[i] >= first_pass || each.format != wanted.format ||
                each.samples != wanted.samples || each.depth != wanted.depth ||
                each.mips != wanted.mips)
                continue;
            each.targets.push_back(wanted.targets.front());
            busy_until[i] = last_pass;
            return static_cast<int>(i);
        }
        textures.push_back(wanted);
        busy_until.push_back(last_pass);
        return static_cast<int>(textures.size()) - 1;
    }
};

/// What fitting knows of a target: its place in the description, and what it is drawn into.
struct Fitted {
    int index = -1;
    PlanTexture texture = {};
};

// The first target that a pass writes: of colour, or else of depth.
int firstWritten(const Description& description, const PlanPass& pass)
{
    if (!pass.color.empty()) return indexOf(description.targets, pass.color.front().name);
    return pass.has_depth ? indexOf(description.targets, pass.depth.name) : -1;
}

// As the config says, or more where a target's border of whole pixels shows more.
float frustumScale(const Description& description, const PlanPass& pass, int written,
                   const TargetSizes& sizes)
{
    const PassDesc& desc = *findNamed(description.passes, pass.name);
    const ParamDesc* param = findNamed(description.params, desc.frustum_scale_param.name);
    const float scale = param ? param->value[0] : desc.frustum_scale;
    if (scale <= 0.0f || written < 0) return scale;
    return std::max(scale, sizes.viewsOf(written));
}

// Samples that the device has for all that a pass draws into.
int samplesOf(const Description& description, const PlanPass& pass, int written,
              const std::vector<Fitted>& fitted, const DeviceCaps& caps)
{
    const int asked = askedSamples(description, written);
    std::uint32_t counts = ~0u;
    const auto restrict = [&](const PlanAttachment& each) {
        if (each.target < 0) return;
        const Format format = fitted[each.target].texture.format;
        counts &= caps.sample_counts[static_cast<int>(format)];
    };
    for (const PlanAttachment& color : pass.color) restrict(color);
    if (pass.has_depth && !isMasked(pass)) restrict(pass.depth);
    return asked == 1 ? 1 : nearestCount(counts, asked);
}

void fitPass(PlanPass& pass, const Description& description, const CompileOptions& options,
             const DeviceCaps& caps, const TargetSizes& sizes, std::vector<Fitted>& fitted)
{
    const int written = firstWritten(description, pass);
    const bool culls =
        !contains(options.disable, "frustum_culling") && !contains(options.disable, "all");
    pass.frustum_scale = culls ? frustumScale(description, pass, written, sizes) : 0;
    pass.extent = sizes.of(written);
    pass.layers = pass.color.empty() || written < 0 ? 0 : depthOf(description, written);
    pass.samples = 1;
    // What it draws over was resolved by the pass before.
    if (written < 0 || pass.over >= 0) return;
    pass.samples = samplesOf(description, pass, written, fitted, caps);
    const auto take = [&](const PlanAttachment& each) {
        if (each.target >= 0) fitted[each.target].texture.samples = pass.samples;
    };
    for (const PlanAttachment& color : pass.color) take(color);
    if (pass.has_depth && !isMasked(pass)) take(pass.depth);
}

// Fills the plan's texture list and each target's slot.
void shareTextures(Plan& plan, const Description& description, const DeviceCaps& caps,
                   const std::vector<Fitted>& fitted, bool share)
{
    Slots slots{plan.textures, share};
    for (std::size_t i = 0; i < plan.targets.size(); ++i) {
        PlanTarget& target = plan.targets[i];
        PlanTexture texture = fitted[i].texture;
        if (target.history_texture >= 0) {
            texture.copies = plan.views;
            target.texture = target.drawn_texture =
                slots.take(texture, -1, target.last_pass, false);
            texture.targets = {historyName(description.targets[fitted[i].index])};
            target.history_texture = slots.take(texture, -1, target.last_pass, false);
            continue;
        }
        const bool depth = formatInfo(texture.format).format_class == FormatClass::depth;
        const bool unread = target.last_pass == target.first_pass;
        const bool resolved = texture.samples > 1 && !unread;
        const bool part = depth && unread && !caps.equal_attachments;
        const int last_drawn = resolved ? target.first_pass : target.last_pass;
        target.texture = target.drawn_texture =
            slots.take(texture, target.first_pass, last_drawn, part);
        if (resolved) {
            texture.samples = 1;
            target.texture = slots.take(texture, target.first_pass, target.last_pass, false);
        }
        const bool boxed = plan.passes[target.first_pass].box >= 0;  // and so of all views
        if (target.last_pass == static_cast<int>(plan.passes.size()) && !boxed)
            plan.textures[target.texture].copies = plan.views;
    }
}

// What draws the scene often, for passes of boxes alone to read, takes some frames to do it again.
void spreadOverFrames(Plan& plan)
{
    constexpr int kMostDraws = 20;  // of the scene in a frame
    const auto outlives_frame = [&plan](const PlanAttachment& each) {
        return each.target >= 0 &&
               plan.targets[each.target].last_pass == static_cast<int>(plan.passes.size());
    };
    for (PlanPass& pass : plan.passes) {
        const bool drawn_again = pass.box >= 0 && pass.type == PassType::draw && !plan.reruns;
        if (!drawn_again || pass.layers == 0 || anyOf(pass.color, outlives_frame)) continue;
        pass.frames = (pass.layers / pass.layers_at_once + kMostDraws - 1) / kMostDraws;
    }
}

}  // namespace

bool isMasked(const PlanPass& pass)
{
    return pass.type == PassType::fullscreen && pass.has_depth && pass.depth.load == LoadOp::load;
}

double textureBytes(const PlanTexture& texture)
{
    double texels = 0;
    for (int level = 0; level == 0 || texture.mips; ++level) {
        const auto edge = [level](int size) { return std::max(size >> level, 1); };
        const double of_level =
            double(edge(texture.extent.width)) * edge(texture.extent.height) * edge(texture.depth);
        texels += of_level;
        if (of_level == 1) break;
    }
    return texels * texture.samples * formatInfo(texture.format).bytes * texture.copies;
}

void fitPlan(Plan& plan, const Description& description, const SceneTraits& traits,
             const DeviceCaps& caps, const CompileOptions& options)
{
    plan.extent = options.extent;
    plan.views = std::max(traits.views, 1);
    for (PlanParam& param : plan.params)
        param.initial =
            sceneUnits(*findNamed(description.params, param.name), traits, options.extent.height);
    for (GeneratorDesc& each : plan.generated)
        each.count = generatedCount(description, *findNamed(description.generated, each.name));
    for (ImportDesc& import : plan.imports)
        import.format = findNamed(description.imports, import.name)->format;
    const TargetSizes sizes(description, options.extent);
    std::vector<Fitted> fitted;
    for (const PlanTarget& target : plan.targets) {
        const int index = indexOf(description.targets, target.name);
        const TargetDesc& desc = description.targets[index];
        fitted.push_back({index,
                          {chooseFormat(description, desc, traits, caps, options.extent.height),
                           sizes.of(index),
                           1,
                           depthOf(description, index),
                           desc.mips,
                           {target.name}}});
    }
    for (PlanPass& pass : plan.passes) {
        fitPass(pass, description, options, caps, sizes, fitted);
        for (PlanUniform& uniform : pass.uniforms)
            if (uniform.source == UniformSource::kernel)
                uniform.count = plan.generated[uniform.index].count;
    }
    shareTextures(plan, description, caps, fitted,
                  !contains(options.disable, "aliasing") && !contains(options.disable, "all"));
    spreadOverFrames(plan);
    for (const PlanTexture& texture : plan.textures) plan.texture_bytes += textureBytes(texture);
}

Status checkBytes(const Plan& plan, const Description& description)
{
    constexpr double kMiB = 1 << 20;
    const auto mib = [](double bytes) { return significant(bytes / kMiB, 4) + " MiB"; };
    const double bytes = plan.texture_bytes;
    if (bytes <= description.limits.bytes) return {};
    const auto smaller = [](const PlanTexture& a, const PlanTexture& b) {
        return textureBytes(a) < textureBytes(b);
    };
    const PlanTexture& largest =
        *std::max_element(plan.textures.begin(), plan.textures.end(), smaller);
    return Diagnostic{
        Code::over_limit,
        "its textures take " + mib(bytes) + ", and at most " + mib(description.limits.bytes) +
            " may be: " + std::to_string(plan.textures.size()) + " of them, the largest of " +
            mib(textureBytes(largest)) + " for " + joined(largest.targets),
        "ask for a smaller size, give targets a smaller format or `scale`, or raise "
        "Limits::bytes (--limit bytes=" +
            fixed(bytes, 0) + ")",
        description.place};
}

}  // namespace crevice
