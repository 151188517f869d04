// SPDX-License-Identifier: MIT
#include "core/run/dirty_passes.h"

#include <algorithm>

namespace crevice {
namespace {

constexpr int kNothing = -1;

}  // namespace

PassCache::PassCache(const Plan& plan)
    : plan_(plan),
      slots_(plan.textures.size() * plan.views, kNothing),
      next_slots_(slots_),
      runs_(plan.passes.size() * plan.views)
{
    const auto remembered = [&plan](int target) {
        return plan.targets[target].history_texture >= 0;
    };
    for (const PlanPass& pass : plan.passes) {
        PassNode& node = passes_.emplace_back();
        for (const PlanInput& input : pass.inputs) {
            if (input.kind == InputKind::target) node.reads.push_back(input.index);
            node.remembers = node.remembers || input.kind == InputKind::history;
        }
        for (const PlanAttachment& color : pass.color)
            if (color.target >= 0) node.writes.push_back(color.target);
        if (pass.has_depth && pass.depth.target >= 0 && !isMasked(pass))
            node.writes.push_back(pass.depth.target);
        node.remembers =
            node.remembers || std::any_of(node.writes.begin(), node.writes.end(), remembered);
    }
    for (const PlanOutput& output : plan.outputs)
        if (output.target >= 0) outputs_.push_back(output.target);
}

void PassCache::clear() { std::fill(slots_.begin(), slots_.end(), kNothing); }

int PassCache::slotOf(int view, int target) const
{
    const int texture = plan_.targets[target].texture;
    return texture * plan_.views + (plan_.textures[texture].copies > 1 ? view : 0);
}

int PassCache::contentOf(int view, int target) const
{
    return view * static_cast<int>(plan_.targets.size()) + target;
}

const std::vector<char>& PassCache::choose(const std::vector<char>& changed)
{
    for (int view = 0; view < plan_.views; ++view)
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            const PassNode& pass = passes_[i];
            const auto redrawn = [&](int target) {
                return runs_[runOf(view, plan_.targets[target].first_pass)] != 0;
            };
            const int run = runOf(view, static_cast<int>(i));
            runs_[run] = changed[run] || pass.remembers ||
                         std::any_of(pass.reads.begin(), pass.reads.end(), redrawn);
        }
    do next_slots_ = slots_;
    while (findOverwritten());
    slots_.swap(next_slots_);
    return runs_;
}

/// Goes through the frame with what is chosen so far, and chooses whoever wrote what is read, or
/// asked for at the end, and is no longer there. True when there was one.
bool PassCache::findOverwritten()
{
    bool found = false;
    for (int view = 0; view < plan_.views; ++view)
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            if (!runs_[runOf(view, static_cast<int>(i))]) continue;
            for (const int target : passes_[i].reads) found = requireTarget(view, target) || found;
            for (const int target : passes_[i].writes)
                next_slots_[slotOf(view, target)] = contentOf(view, target);
        }
    for (int view = 0; view < plan_.views; ++view)
        for (const int target : outputs_) found = requireTarget(view, target) || found;
    return found;
}

bool PassCache::requireTarget(int view, int target)
{
    if (next_slots_[slotOf(view, target)] == contentOf(view, target)) return false;
    char& writer = runs_[runOf(view, plan_.targets[target].first_pass)];
    if (writer)
        return false;  // it runs, and what it wrote was overwritten before: the plan's business
    writer = 1;
    return true;
}

}  // namespace crevice
