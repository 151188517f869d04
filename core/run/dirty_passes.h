// SPDX-License-Identifier: MIT
// Which passes of a plan a frame must run: those whose input has changed since they ran last, all
// that read what those write, and those whose picture another one has overwritten meanwhile. Of
// passes of boxes, whose picture may be some frames old, one a frame in turn, or a part of it, but
// for what was never drawn; they are of all views, and run with the first.
//
// Private to the renderer, and pure: it knows textures by their numbers in the plan.
#pragma once

#include <crevice/plan.h>

namespace crevice {

class PassCache {
public:
    /// Of a pass's drawings one of `count` equal shares.
    struct Share {
        int index = 0, count = 1;
        bool isFirst() const { return index == 0; }
        bool isLast() const { return index + 1 == count; }
    };

    explicit PassCache(const Plan& plan);

    /// Nothing is drawn yet, or nobody knows what has been.
    void clear();

    /// Chooses for a frame. `changed`: by run (view * passes + pass), whether uniforms, draws or
    /// imported textures of it are others than when it ran last. The passes chosen count as run
    /// from then on. The answer is by run as well, and stays until the next call.
    const std::vector<char>& choose(const std::vector<char>& changed);

    /// What is to be drawn of a pass that was chosen.
    Share shareOf(std::size_t pass) const { return passes_[pass].share; }

private:
    static constexpr int kNothing = -1;

    struct PassNode {
        int over = -1;            // the pass on whose outputs it draws: both run, or neither
        std::vector<int> reads;   // targets
        std::vector<int> writes;  // targets that are kept
        bool remembers = false;   // reads or writes what changes with every frame
        bool boxed = false;       // of a box
        bool pending = false;     // ... and to be drawn
        Share share = {};         // drawn last
        bool drawn = false;       // all of it, once
    };

    int runOf(int view, int pass) const { return view * static_cast<int>(passes_.size()) + pass; }
    int slotOf(int view, int target) const;
    int writerOf(int view, int target) const
    {
        const int pass = plan_.targets[target].first_pass;
        return runOf(passes_[pass].boxed ? 0 : view, pass);
    }
    void chooseBoxed(const std::vector<char>& changed);
    bool findOverwritten();
    bool requireTarget(int view, int target);
    void runWhole(int run);

    const Plan& plan_;
    std::vector<PassNode> passes_;
    std::size_t turn_ = 0;         // the pass of a box whose turn it is, or one before it
    std::vector<int> slots_;       // whose picture each texture holds: a run, or kNothing
    std::vector<int> next_slots_;  // ... while a frame is gone through
    std::vector<char> runs_;
};

}  // namespace crevice
