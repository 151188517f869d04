// SPDX-License-Identifier: MIT
// Passes of the occlusion.
#include "tools/measure/stress/passes.h"

#include "tools/measure/stress/figures.h"

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

/// The target whose occlusion the pass hands on to `target`; empty where it makes its own.
std::string keptBy(const Plan& plan, const Description& description, const PlanPass& pass,
                   const std::string& target)
{
    const PassDesc* desc = findNamed(description.passes, pass.name);
    if (!desc) return "";
    for (const PreservesConstantDesc& each : desc->preserves_constant)
        for (const PlanInput& input : pass.inputs)
            if (each.name == target && input.name == each.sampler.name &&
                input.kind == InputKind::target)
                return plan.targets[input.index].name;
    return "";
}

/// Of a share of the exact occlusion.
bool isOff(double kept, double least, double most) { return !(kept >= least && kept <= most); }

}  // namespace

std::vector<PassPicture> occlusionPasses(const Plan& plan, const Description& description,
                                         const std::string& output)
{
    std::vector<PassPicture> passes;
    const OutputDesc* desc = findNamed(description.outputs, output);
    std::string target = desc ? desc->target.name : "";
    while (const PlanTarget* found = findNamed(plan.targets, target)) {
        const PlanPass& pass = plan.passes[found->first_pass];
        passes.push_back({pass.name, target});
        target = keptBy(plan, description, pass, target);
    }
    std::reverse(passes.begin(), passes.end());
    return passes;
}

std::string departingPass(const StressCase& stress, const StressShot& shot,
                          const std::vector<PassPicture>& passes,
                          const std::vector<PassPicture>& ordinary, const StressRecord& record)
{
    if (shot.output != "ao") return passes.empty() ? "" : passes.back().pass;
    const bool is_ordinary = record.step == static_cast<int>(stress.ordinary);
    const double least = is_ordinary ? kLeastStrength : kLeastKept;
    const double most = is_ordinary ? kMostStrength : kMostKept;
    const double kept = record.exact > 0 ? record.occlusion / record.exact : 1;
    const double whole = std::max(1 - record.mean, 1e-9);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        StressRecord figures;
        describeOcclusion(passes[i].occlusion, figures);
        if (record.out_of_range > 0 && figures.out_of_range > 0) return passes[i].pass;
        const double occlusion = 1 - figures.mean;
        const bool plain =
            stress.expectation == Expectation::open || stress.expectation == Expectation::one;
        if (plain && occlusion > 1 - kOpenMean && occlusion >= whole / 2) return passes[i].pass;
        if (!plain && isOff(kept, least, most) && isOff(kept * occlusion / whole, least, most))
            return passes[i].pass;
        if (stress.expectation != Expectation::same || i >= ordinary.size()) continue;
        const double change =
            changeBetween(ordinary[i].occlusion, passes[i].occlusion, shot).change;
        if (change > stress.limit && change >= record.change / 2) return passes[i].pass;
    }
    return "";
}

}  // namespace crevice
