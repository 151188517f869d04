// SPDX-License-Identifier: MIT
// What is left out, and why: by `when`, against features and the scene's traits, or as the steps
// before found.
#include "core/compile/steps.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/frame/frame_values.h"

namespace crevice::compiler {

namespace {

const char* boolText(bool value) { return value ? "true" : "false"; }

// What a subject is now, as a condition would write it.
std::string valueOf(const State& state, const std::string& subject)
{
    if (const TraitInfo* trait = findNamed(kTraits, subject)) {
        const int value = trait->value(state.traits);
        return trait->count ? std::to_string(value) : boolText(value != 0);
    }
    const FeatureDesc* feature = findNamed(state.description.features, subject);
    return feature ? feature->values[feature->value] : "unknown";
}

bool termHolds(const State& state, const Condition::Term& term)
{
    const std::string value = valueOf(state, term.subject.name);
    const TraitInfo* trait = findNamed(kTraits, term.subject.name);
    return contains(term.values, value) ||
           (trait && trait->count && contains(term.values, boolText(value != "0")));
}

// "it needs scene.lights true, and scene.lights is 0".
std::string whyNot(const State& state, const Condition::Term& term)
{
    const std::string& subject = term.subject.name;
    return "it needs " + subject + " " + joined(term.values, " or ") + ", and " + subject + " is " +
           valueOf(state, subject);
}

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

void decideConditions(State& state)
{
    for (Pass& pass : state.passes) {
        for (const Condition::Term& term : pass.desc->when.terms) {
            if (termHolds(state, term)) continue;
            pass.active = false;
            pass.off_reason = whyNot(state, term);
            break;
        }
    }
}

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
