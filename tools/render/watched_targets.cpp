// SPDX-License-Identifier: MIT
// Exporting targets.
#include "tools/render/watched_targets.h"

#include "tools/render/output_source.h"

namespace crevice {

Format formatOf(const Plan& plan, const std::string& target)
{
    const PlanTarget* found = findNamed(plan.targets, target);
    return found ? plan.textures[found->texture].format : Format::none;
}

std::vector<WatchedTarget> watchAll(const Plan& plan, Description& description)
{
    std::vector<WatchedTarget> watched;
    for (const PlanPass& pass : plan.passes) {
        const auto watch = [&](const PlanAttachment& attachment) {
            if (attachment.target < 0) return;
            const Result<OutputSource> source =
                exposeOutput(description, "target." + attachment.name);
            if (source) watched.push_back({attachment.name, pass.name, source->output});
        };
        for (const PlanAttachment& color : pass.color) watch(color);
        if (pass.has_depth && !isMasked(pass)) watch(pass.depth);
    }
    return watched;
}

}  // namespace crevice
