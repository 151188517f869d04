// SPDX-License-Identifier: MIT
// What passes read of a draw and nobody gives them: told once for a plan, in the frame that first
// draws so.
#pragma once

#include <crevice/frame.h>
#include <crevice/plan.h>

#include "core/frame/frame_values.h"

#include <iterator>
#include <utility>
#include <vector>

namespace crevice {

class DrawWarnings {
public:
    /// Takes note of what a pass of the plan reads: `active` is what its program really has. The
    /// plan must outlive this.
    void add(const Plan& plan, const PlanPass& pass, const std::vector<UniformInfo>& active);

    /// Looks at what is drawn, with its mesh. Allocates only where there is something to say.
    void look(const DrawItem& item, const ObjectInfo& mesh, const Material& material);

    /// What is new since the last call.
    Diagnostics take() { return std::exchange(found_, {}); }

private:
    struct Reader {
        const Plan* plan = nullptr;  ///< Null where no pass reads it, or that was told.
        const PlanPass* pass = nullptr;
    };

    void warn(Reader& reader, const ObjectInfo& mesh, const char* lacks, const char* help);
    void warnOfBlock(const ObjectInfo& mesh);

    Reader normals_, maps_[std::size(kMaterialMaps)], blocks_;
    Diagnostics found_;
};

}  // namespace crevice
