// SPDX-License-Identifier: MIT
// Aliasing: targets whose lifetimes do not meet share a texture.
#include "core/compile/steps.h"

namespace crevice::compiler {

namespace {

// The plan's textures, and until which pass each is busy.
class Slots {
public:
    Slots(std::vector<PlanTexture>& textures, bool share) : textures_(textures), share_(share) {}

    // One that is free by `first_pass`, or a new one: before pass 0 none is free. For what no pass
    // reads, a part of a larger one will do as well, on devices that take it.
    int take(const PlanTexture& wanted, int first_pass, int last_pass, bool part)
    {
        for (std::size_t i = 0; share_ && i < textures_.size(); ++i) {
            PlanTexture& each = textures_[i];
            const bool fits = part ? each.extent.width >= wanted.extent.width &&
                                         each.extent.height >= wanted.extent.height
                                   : each.extent == wanted.extent;
            if (!fits || busy_until_[i] >= first_pass || each.format != wanted.format ||
                each.samples != wanted.samples)
                continue;
            each.targets.push_back(wanted.targets.front());
            busy_until_[i] = last_pass;
            return static_cast<int>(i);
        }
        textures_.push_back(wanted);
        busy_until_.push_back(last_pass);
        return static_cast<int>(textures_.size()) - 1;
    }

private:
    std::vector<PlanTexture>& textures_;
    std::vector<int> busy_until_;
    bool share_;
};

}  // namespace

void shareTextures(const State& state, Plan& plan)
{
    Slots slots(plan.textures, state.applies("aliasing"));
    for (PlanTarget& target : plan.targets) {
        const int index = indexOf(state.description.targets, target.name);
        const TargetDesc& desc = state.description.targets[index];
        const Target& found = state.targets[index];
        PlanTexture texture{found.format, found.extent, found.samples, {target.name}};
        if (found.remembered) {
            texture.copies = plan.views;
            target.texture = target.drawn_texture =
                slots.take(texture, -1, target.last_pass, false);
            texture.targets = {historyName(desc)};
            target.history_texture = slots.take(texture, -1, target.last_pass, false);
            continue;
        }
        const bool depth = formatInfo(found.format).format_class == FormatClass::depth;
        const bool unread = target.last_pass == target.first_pass;
        const bool resolved = found.samples > 1 && !unread;
        const bool part = depth && unread && !state.caps.equal_attachments;
        const int last_drawn = resolved ? target.first_pass : target.last_pass;
        target.texture = target.drawn_texture =
            slots.take(texture, target.first_pass, last_drawn, part);
        if (resolved) {
            texture.samples = 1;
            target.texture = slots.take(texture, target.first_pass, target.last_pass, false);
        }
        if (target.last_pass == static_cast<int>(plan.passes.size()))
            plan.textures[target.texture].copies = plan.views;
    }
}

}  // namespace crevice::compiler
