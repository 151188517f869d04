// SPDX-License-Identifier: MIT
// What is left out, and why: by `when`, against features and the scene's traits; and dead passes,
// those that no output needs. What stands in for passes is chosen here too.
#include "core/compile/steps.h"

#include "core/config/values.h"
#include "core/frame/frame_math.h"

namespace crevice::compiler {
namespace {

Source targetNamed(const State& state, const std::string& name)
{
    return {InputKind::target, indexOf(state.description.targets, name)};
}

// What the pass reads by that sampler; nothing where its shader, as it is now, has none.
std::optional<Source> readBy(const Pass& pass, const std::string& sampler)
{
    const Read* read = findNamed(pass.reads, sampler);
    return read ? std::optional<Source>(read->named) : std::nullopt;
}

// What a pass that does not run says its output is: by `bypass`, `no_op` or `preserves_constant`.
std::optional<Source> substitute(const State& state, const Pass& pass, int target)
{
    const std::string& name = nameOf(state, target);
    if (!pass.active) {
        const BypassDesc* bypass = findNamed(pass.desc->bypass, name);
        return bypass ? targetNamed(state, bypass->input.name) : std::optional<Source>();
    }
    if (!pass.no_op) {
        const PreservesConstantDesc* kept = findNamed(pass.desc->preserves_constant, name);
        return kept ? readBy(pass, kept->sampler.name) : std::nullopt;
    }
    const NoOpDesc::Gives* gives = findNamed(pass.no_op->gives, name);
    if (!gives) return std::nullopt;
    if (gives->constant) return Source{InputKind::constant, -1, gives->value};
    return targetNamed(state, gives->input.name);
}

// Whether a texture of `by` reads as one of `replaced` would that a pass has copied it into.
bool storedAlike(const State& state, int replaced, int by)
{
    const FormatInfo& wanted = formatInfo(state.targets[replaced].format);
    const FormatInfo& given = formatInfo(state.targets[by].format);
    return given.format_class == wanted.format_class && given.channels >= wanted.channels &&
           given.absolute_step == wanted.absolute_step &&
           given.relative_step == wanted.relative_step;
}

// Whether each target that the no-op gives for another one is stored as that is.
bool givesAlike(const State& state, const NoOpDesc& no_op)
{
    return allOf(no_op.gives, [&](const NoOpDesc::Gives& each) {
        const int replaced = indexOf(state.description.targets, each.name);
        const int by = indexOf(state.description.targets, each.input.name);
        return each.constant || replaced < 0 || by < 0 || storedAlike(state, replaced, by);
    });
}

// The next no-op of the pass, after its present one, whose param has its value.
const NoOpDesc* nextNoOp(const State& state, const Pass& pass)
{
    const std::vector<NoOpDesc>& all = pass.desc->no_op;
    std::size_t i = pass.no_op ? pass.no_op - all.data() + 1 : 0;
    for (; i < all.size(); ++i) {
        const ParamDesc* param = findNamed(state.description.params, all[i].name);
        const bool holds = param && isAll(param->value, param->type, all[i].at);
        if (holds && givesAlike(state, all[i])) return &all[i];
    }
    return nullptr;
}

bool preservesConstant(const State& state, const Pass& pass)
{
    const auto constant = [&](const PreservesConstantDesc& each) {
        const std::optional<Source> source = readBy(pass, each.sampler.name);
        const std::optional<Source> behind = source ? resolve(state, *source) : std::nullopt;
        return behind && behind->kind == InputKind::constant;
    };
    const std::vector<PreservesConstantDesc>& all = pass.desc->preserves_constant;
    return !all.empty() && allOf(all, constant);
}

// Leaves out what only passes constants on, in the order of data flow: one may hang on another.
void chooseConstant(State& state)
{
    for (Pass& pass : state.passes) pass.preserves_constant = false;
    for (const int index : state.order) {
        Pass& pass = state.passes[index];
        pass.preserves_constant =
            !pass.no_op && !pass.indispensable && preservesConstant(state, pass);
    }
}

// Finds what the outputs need. Returns -1, or a pass whose stand-in lacks an output that is needed.
int markNeeded(State& state)
{
    for (Pass& pass : state.passes) pass.live = false;
    for (Target& target : state.targets) target.textured = target.remembered = false;
    std::vector<Source> work;
    const auto need = [&work](Pass& pass) {
        if (pass.live) return;
        pass.live = true;
        for (const Read& read : pass.reads) work.push_back(read.named);
    };
    for (const int index : state.order)
        if (Pass& pass = state.passes[index]; !state.applies("dead_pass") && !pass.replaced())
            need(pass);
    for (const int index : state.outputs)
        work.push_back(targetNamed(state, state.description.outputs[index].target.name));
    while (!work.empty()) {
        const std::optional<Source> behind = resolve(state, work.back());
        work.pop_back();
        if (!behind || !behind->isTarget()) continue;
        Target& target = state.targets[behind->index];
        if (state.passes[target.writer].replaced()) return target.writer;
        target.textured = true;
        target.remembered = target.remembered || behind->kind == InputKind::history;
        need(state.passes[target.writer]);
    }
    return -1;
}

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

bool termHolds(const State& state, const Condition& term)
{
    const std::string value = valueOf(state, term.name);
    const TraitInfo* trait = findNamed(kTraits, term.name);
    return contains(term.values, value) ||
           (trait && trait->count && contains(term.values, boolText(value != "0")));
}

// "ao is 1 everywhere, and so is ao_blur".
std::string constantReason(const State& state, const Pass& pass)
{
    std::string reason;
    for (const PreservesConstantDesc& each : pass.desc->preserves_constant) {
        const int output = indexOf(state.description.targets, each.name);
        reason += (reason.empty() ? "" : "; ") + each.sampler.name + " is " +
                  shortest(resolveTarget(state, output)->value) + " everywhere, and so is " +
                  each.name;
    }
    return reason;
}

// "intensity is 0, so ao is 1".
std::string substituteReason(const Pass& pass)
{
    std::string given;
    for (const NoOpDesc::Gives& gives : pass.no_op->gives)
        given += (given.empty() ? "" : ", ") + gives.name + " is " +
                 (gives.constant ? shortest(gives.value) : gives.input.name);
    return pass.no_op->name + " is " + shortest(pass.no_op->at) + ", so " + given;
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

std::optional<Source> resolve(const State& state, const Source& source)
{
    // Nothing can stand in for what a target held: without its writer there is none.
    if (source.kind == InputKind::history && state.targets[source.index].writer < 0)
        return std::nullopt;
    std::optional<Source> at = source;
    for (std::size_t steps = 0; steps <= state.targets.size(); ++steps) {
        if (!at || at->kind != InputKind::target) return at;
        const int target = at->index;
        const int writer = state.targets[target].writer;
        if (writer >= 0) {
            const Pass& pass = state.passes[writer];
            const auto given = pass.replaced() ? substitute(state, pass, target) : std::nullopt;
            if (!given) return at;
            at = given;
            continue;
        }
        at = std::nullopt;
        for (const Pass& pass : state.passes)
            if (!at && !pass.active) at = substitute(state, pass, target);
    }
    return std::nullopt;  // stand-ins that lead round in a circle
}

std::optional<Source> resolveTarget(const State& state, int target)
{
    return resolve(state, {InputKind::target, target});
}

void chooseLive(State& state)
{
    markNeeded(state);
    for (Target& target : state.targets) target.wanted = target.textured;
    // Begin with every no-op that holds and take back those that do not fit: what is left then
    // needs the least, and each round takes one back, so it ends.
    if (state.applies("no_op"))
        for (Pass& pass : state.passes)
            if (pass.active) pass.no_op = nextNoOp(state, pass);
    while (true) {
        if (state.applies("no_op")) chooseConstant(state);
        const int conflict = markNeeded(state);
        if (conflict < 0) break;
        Pass& pass = state.passes[conflict];
        if (pass.no_op)
            pass.no_op = nextNoOp(state, pass);
        else
            pass.indispensable = true;
    }
    for (const Pass& pass : state.passes)
        for (const int target : writtenBy(pass))
            if (pass.live && (target == pass.depth || !state.applies("dead_pass")))
                state.targets[target].textured = true;
}

void lintDeadPasses(State& state)
{
    // Where something was asked for, or something stands in, that is what leaves passes out.
    const bool reduced = anyOf(state.passes, [](const Pass& pass) { return pass.replaced(); });
    if (reduced || !state.options.outputs.empty() || hasErrors(state.diagnostics)) return;
    for (const Pass& pass : state.passes)
        if (pass.active && !pass.live)
            report(state, Code::dead_pass,
                   quoted(pass) + " does not run: no output needs what it writes", *pass.desc,
                   "read what it writes, export it under `outputs`, or leave out the module")
                .severity = Severity::warning;
}

void decideConditions(State& state)
{
    for (Pass& pass : state.passes)
        for (const Condition& term : pass.desc->when) {
            if (!pass.active || termHolds(state, term)) continue;
            pass.active = false;  // "it needs scene.lights true, and scene.lights is 0"
            pass.off_reason = "it needs " + term.name + " " + joined(term.values, " or ") +
                              ", and " + term.name + " is " + valueOf(state, term.name);
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
