// SPDX-License-Identifier: MIT
// What `crevice choose` does, for what the page shows: a part at a time, and frames are timed by
// the page, since a browser says only after a while what they took.
#pragma once

#include "tools/measure/bench/quick.h"
#include "tools/show/page/engine/answers.h"
#include "tools/show/page/engine/stage.h"

namespace crevice::page {

class Chooser {
public:
    /// Begins anew: {"camera", "radius", "budget": "2ms", "error": 0.05}, of
    /// which all may lack. Errors: CV8001 for a budget that
    /// is none; those of Stage::camera.
    Status begin(Device& device, const Stage& stage, Extent extent, const Json& wanted);

    /// Does the next part. {"ok", "diagnostics", "more", "due", "lines", "found"}: whether there is
    /// more, whether a frame is to be timed before that, what was said, and, where that is new,
    /// what is known, by rising cost.
    Json step();

    /// Takes what the frame took that was due, and gives the same.
    Json add(const FrameTimes& times);

    /// Whose frame is to be timed; null where that is nothing.
    TurnTaker* due() const;

    /// {"text"}: a config that says what {"config", "overrides"} says. Errors: those of loadConfig.
    static Json textOf(const Json& found);

private:
    Json state(Json json);
    Json found() const;
    Diagnostics leftOut() const;

    BenchView view_;
    ChoiceLimits limits_;
    std::unique_ptr<QuickBench> bench_;
    std::vector<std::string> lines_;
    int disturbed_ = 0;  // frames in a row
};

}  // namespace crevice::page
