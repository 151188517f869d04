// SPDX-License-Identifier: MIT
// What each pass of a plan is for.
#include "tools/measure/cost/cost.h"

#include "core/base/text.h"
#include "tools/show/plan/print.h"

namespace crevice {
namespace {

bool readsTarget(const PlanPass& pass, int target)
{
    return anyOf(pass.inputs, [&](const PlanInput& input) {
        const bool drawn = input.kind == InputKind::target || input.kind == InputKind::history;
        return drawn && input.index == target;
    });
}

/// What the pass writes and something reads.
std::vector<int> targetsOf(const PlanPass& pass)
{
    std::vector<int> targets;
    for (const PlanAttachment& color : pass.color)
        if (color.target >= 0) targets.push_back(color.target);
    if (pass.has_depth && !isMasked(pass) && pass.depth.target >= 0)
        targets.push_back(pass.depth.target);
    return targets;
}

/// Marks the passes that draw on the target, and all that they need.
void markWriters(const Plan& plan, int target, std::vector<bool>& needed)
{
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const std::vector<int> drawn = targetsOf(plan.passes[i]);
        if (needed[i] || std::find(drawn.begin(), drawn.end(), target) == drawn.end()) continue;
        needed[i] = true;
        for (std::size_t other = 0; other < plan.targets.size(); ++other)
            if (readsTarget(plan.passes[i], static_cast<int>(other)))
                markWriters(plan, static_cast<int>(other), needed);
    }
}

std::vector<bool> neededForAo(const Plan& plan)
{
    std::vector<bool> needed(plan.passes.size(), false);
    const auto isAo = [](const PlanOutput& output) { return output.name == "ao"; };
    const bool has_ao = anyOf(plan.outputs, isAo);
    for (const PlanOutput& output : plan.outputs)
        if (output.target >= 0 && (!has_ao || isAo(output)))
            markWriters(plan, output.target, needed);
    return needed;
}

/// Whether no pass but those of `needed` reads the target, and no output shows it.
bool onlyReadBy(const Plan& plan, const std::vector<bool>& needed, int target)
{
    for (const PlanOutput& output : plan.outputs)
        if (output.target == target) return false;
    for (std::size_t i = 0; i < plan.passes.size(); ++i)
        if (!needed[i] && readsTarget(plan.passes[i], target)) return false;
    return true;
}

}  // namespace

const char* nameOf(PassRole role)
{
    const char* const names[] = {"AO", "geometry for AO", "geometry", "picture"};
    return names[static_cast<int>(role)];
}

std::vector<PassRole> passRoles(const Plan& plan)
{
    const std::vector<bool> needed = neededForAo(plan);
    std::vector<PassRole> roles;
    bool first = true;  // of those that draw depth: every renderer has that one
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const PlanPass& pass = plan.passes[i];
        const std::vector<int> targets = targetsOf(pass);
        if (!needed[i]) {
            roles.push_back(PassRole::picture);
        } else if (pass.type == PassType::fullscreen) {
            roles.push_back(PassRole::ao);
        } else if (first && pass.has_depth) {
            roles.push_back(PassRole::geometry);
            first = false;
        } else {
            const bool alone =
                allOf(targets, [&](int target) { return onlyReadBy(plan, needed, target); });
            roles.push_back(alone ? PassRole::geometry_for_ao : PassRole::geometry);
        }
    }
    return roles;
}

double bytesForAo(const Plan& plan, const std::vector<PassRole>& roles)
{
    const std::vector<bool> needed = neededForAo(plan);
    double bytes = 0;
    for (std::size_t i = 0; i < plan.passes.size(); ++i) {
        const PlanPass& pass = plan.passes[i];
        if (roles[i] != PassRole::geometry) continue;
        for (const PlanAttachment& color : pass.color)
            if (color.target >= 0 && color.store == StoreOp::store &&
                onlyReadBy(plan, needed, color.target))
                bytes += double(pass.extent.width) * pass.extent.height * plan.views *
                         formatInfo(textureOf(plan, color.target).format).bytes;
    }
    return bytes;
}

}  // namespace crevice
