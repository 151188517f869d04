// SPDX-License-Identifier: MIT
#include "core/run/dirty_passes.h"

#include "core/base/text.h"

namespace crevice {

PassCache::PassCache(const Plan& plan)
    : plan_(plan),
      slots_(plan.textures.size() * plan.views, kNothing),
      next_slots_(slots_),
      runs_(plan.passes.size() * plan.views)
{
    const auto remembered = [&](int target) { return plan.targets[target].history_texture >= 0; };
    for (const PlanPass& pass : plan.passes) {
        PassNode& node = passes_.emplace_back();
        node.over = pass.over;
        node.boxed = pass.box >= 0 && !plan.reruns;
        for (const PlanInput& input : pass.inputs) {
            if (input.kind == InputKind::target) node.reads.push_back(input.index);
            node.remembers = node.remembers || input.kind == InputKind::history;
        }
        for (const PlanAttachment& color : pass.color)
            if (color.target >= 0) node.writes.push_back(color.target);
        if (pass.has_depth && pass.depth.target >= 0 && !isMasked(pass))
            node.writes.push_back(pass.depth.target);
        node.remembers = node.remembers || anyOf(node.writes, remembered);
    }
}

void PassCache::clear()
{
    slots_.assign(slots_.size(), kNothing);
    for (PassNode& pass : passes_) pass.share = {}, pass.drawn = false;
}

int PassCache::slotOf(int view, int target) const
{
    const int texture = plan_.targets[target].texture;
    return texture * plan_.views + (plan_.textures[texture].copies > 1 ? view : 0);
}

// Of the passes of boxes that have something to draw the next one, or the next share of one.
void PassCache::chooseBoxed(const std::vector<char>& changed)
{
    for (std::size_t i = 0; i < passes_.size(); ++i)
        passes_[i].pending = passes_[i].boxed && (passes_[i].pending || changed[i]);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        const std::size_t at = (turn_ + i) % passes_.size();
        PassNode& pass = passes_[at];
        const bool begun = !pass.share.isLast();
        if (!pass.pending && !begun) continue;
        // What was never drawn is asked for whole.
        pass.share =
            Share{begun ? pass.share.index + 1 : 0, pass.drawn ? plan_.passes[at].frames : 1};
        pass.pending = pass.pending && begun;
        runs_[at] = 1;
        turn_ = pass.share.isLast() ? at + 1 : at;
        return;
    }
}

const std::vector<char>& PassCache::choose(const std::vector<char>& changed)
{
    runs_.assign(runs_.size(), 0);
    chooseBoxed(changed);
    for (int view = 0; view < plan_.views; ++view)
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            const PassNode& pass = passes_[i];
            const auto redrawn = [&](int target) { return runs_[writerOf(view, target)] != 0; };
            const int run = runOf(view, static_cast<int>(i));
            if (pass.boxed) continue;
            runs_[run] = changed[run] || pass.remembers || anyOf(pass.reads, redrawn);
            if (pass.over < 0) continue;
            char& under = runs_[runOf(view, pass.over)];
            under = runs_[run] = under || runs_[run];
        }
    do next_slots_ = slots_;
    while (findOverwritten());
    slots_.swap(next_slots_);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        PassNode& pass = passes_[i];
        pass.drawn = pass.drawn || (runs_[i] && pass.share.isLast());
        const auto redrawn = [&](int target) { return runs_[writerOf(0, target)] != 0; };
        if (pass.boxed && !runs_[i] && anyOf(pass.reads, redrawn)) pass.pending = true;
    }
    return runs_;
}

/// Goes through the frame with what is chosen so far, and chooses whoever wrote what is read, or
/// asked for at the end, and is no longer there. True when there was one.
bool PassCache::findOverwritten()
{
    bool found = false;
    for (int view = 0; view < plan_.views; ++view)
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            char& run = runs_[runOf(view, static_cast<int>(i))];
            if (!run && passes_[i].over >= 0 && runs_[runOf(view, passes_[i].over)]) {
                runWhole(runOf(view, static_cast<int>(i)));
                found = true;
            }
            if (!run) continue;
            for (const int target : passes_[i].reads) found = requireTarget(view, target) || found;
            for (const int target : passes_[i].writes)
                next_slots_[slotOf(view, target)] = writerOf(view, target);
        }
    for (int view = 0; view < plan_.views; ++view)
        for (const PlanOutput& output : plan_.outputs)
            found = (output.target >= 0 && requireTarget(view, output.target)) || found;
    return found;
}

bool PassCache::requireTarget(int view, int target)
{
    const int writer = writerOf(view, target);
    // Where it runs, and what it wrote was overwritten before, that is the plan's business.
    if (next_slots_[slotOf(view, target)] == writer || runs_[writer]) return false;
    runWhole(writer);
    return true;
}

void PassCache::runWhole(int run)
{
    runs_[run] = 1;
    PassNode& pass = passes_[run % static_cast<int>(passes_.size())];
    pass.share = {};
    pass.pending = false;
}

}  // namespace crevice
