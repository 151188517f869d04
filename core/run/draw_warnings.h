// SPDX-License-Identifier: MIT
// What passes read of a draw and nobody gives them, and of a history that is another camera's: told
// once for a plan, in the frame that first draws so.
#pragma once

#include <crevice/frame.h>
#include <crevice/plan.h>

#include "core/frame/frame_math.h"
#include "core/frame/frame_values.h"

#include <iterator>
#include <utility>
#include <vector>

namespace crevice {

class DrawWarnings {
public:
    /// The plan must outlive it.
    explicit DrawWarnings(const Plan& plan);

    /// Takes note of what a pass of the plan reads: `active` is what its program really has.
    void add(const PlanPass& pass, const std::vector<UniformInfo>& active);

    /// Looks at what is drawn, with its mesh. Allocates only where there is something to say.
    void look(const DrawItem& item, const ObjectInfo& mesh, const Material& material);

    /// Looks whether two cameras take turns with one history: `turns` counts the frames in which a
    /// view's camera is nearer to that of two frames ago than to the last one.
    void look(const FrameHistory& two_ago, const FrameHistory& last, const CameraMatrices& now,
              int& turns);

    /// What is new since the last call.
    Diagnostics take() { return std::exchange(found_, {}); }

private:
    using Reader = const PlanPass*;

    void warnOfLack(Reader& reader, const ObjectInfo& mesh, const char* lacks, const char* help);
    void warnOfBlock(const ObjectInfo& mesh);
    Diagnostic& warn(Reader& reader, Code code, std::string message, const char* help);

    const Plan& plan_;
    bool remembers_;  // whether it has a history, and that is not told
    // The first pass that reads each; null where none does, or that was told.
    Reader normals_ = nullptr, maps_[std::size(kMaterialMaps)] = {}, blocks_ = nullptr;
    Diagnostics found_;
};

}  // namespace crevice
