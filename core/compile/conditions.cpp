// SPDX-License-Identifier: MIT
// Which passes run: `when` against features and the scene's traits.
#include "core/compile/steps.h"

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

}  // namespace crevice::compiler
