// SPDX-License-Identifier: MIT
// What is left out, and why.
#include "core/compile/steps.h"

#include "core/base/numbers.h"

namespace crevice::compiler {

namespace {

// "ao is 1 everywhere, and so is ao_blur".
std::string constantReason(const State& state, const Pass& pass)
{
    std::string reason;
    for (const PreservesConstantDesc& each : pass.desc->preserves_constant) {
        const int output = indexOf(state.description.targets, each.output.name);
        reason += (reason.empty() ? "" : "; ") + each.sampler.name + " is " +
                  shortest(resolveTarget(state, output)->value) + " everywhere, and so is " +
                  each.output.name;
    }
    return reason;
}

// "intensity is 0, so ao is 1".
std::string substituteReason(const Pass& pass)
{
    std::string given;
    for (const NoOpDesc::Gives& gives : pass.no_op->gives)
        given += (given.empty() ? "" : ", ") + gives.output.name + " is " +
                 (gives.constant ? shortest(gives.value) : gives.input.name);
    return pass.no_op->param.name + " is " + shortest(pass.no_op->at) + ", so " + given;
}

void addElided(const State& state, const Pass& pass, std::vector<Elided>& elided)
{
    const auto add = [&](const char* optimization, const std::string& reason) {
        elided.push_back({"pass " + pass.desc->name, optimization, reason});
    };
    if (!pass.active)
        add("condition", pass.off_reason);
    else if (pass.no_op)
        add("no_op", substituteReason(pass));
    else if (pass.preserves_constant)
        add("no_op", constantReason(state, pass));
    else if (!pass.live)
        add("dead_pass", "no output asked for needs it");
    if (!pass.live) return;
    for (const int index : pass.color) {
        const Target& target = state.targets[index];
        if (target.textured) continue;
        const char* reason =
            target.wanted ? "no pass reads it" : "no pass reads it, and it is not computed";
        elided.push_back({"attachment " + nameOf(state, index), "dead_pass", reason});
    }
}

}  // namespace

std::vector<Elided> elided(const State& state)
{
    std::vector<Elided> elided = state.elided;
    for (const Pass& pass : state.passes) addElided(state, pass, elided);
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetDesc& desc = state.description.targets[i];
        const Target& target = state.targets[i];
        if (desc.history && target.textured && !target.remembered)
            elided.push_back(
                {"history " + desc.name, "dead_pass", "no pass reads " + historyName(desc)});
    }
    return elided;
}

}  // namespace crevice::compiler
