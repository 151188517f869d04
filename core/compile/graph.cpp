// SPDX-License-Identifier: MIT
// The graph: who writes what, in which order passes run, and what is left out and why: by `when`,
// against features and the scene's traits; and dead passes, those that no output needs. What stands
// in for passes is chosen here too.
#include "core/compile/steps.h"

#include "core/config/values.h"
#include "core/frame/frame_math.h"

namespace crevice::compiler {
namespace {

struct Edge {
    int from;    // writer
    int target;  // what flows
};
using Edges = std::vector<std::vector<Edge>>;  // into each pass

// "pass 'lighting' reads target 'ao', which ..."; with the passes that would have written it.
void reportNeverWritten(State& state, const std::string& reader, int target, const Reference& at)
{
    const std::string& name = nameOf(state, target);
    if (!state.unwritten.insert(name).second) return;
    Diagnostic& error = report(state, Code::never_written,
                               reader + " reads target '" + name + "', which no pass writes", at,
                               "name it under `color` or `depth` of the pass that makes it");
    const Pass* first = nullptr;
    for (const Pass& pass : state.passes) {
        if (referenceTo(pass, name).name != name) continue;
        if (!first) first = &pass;
        error.notes.push_back({pass.desc->place, quoted(pass) + " would write it"});
        for (const Condition& term : pass.desc->when)
            error.notes.push_back({term.place, "its condition is here"});
    }
    if (first) {
        error.message = reader + " reads target '" + name + "', which " + quoted(*first) +
                        " would write, but " +
                        (first->active ? "an #if takes it out of its shader" : first->off_reason);
        error.help = first->active ? "read it under the same #if"
                                   : "give '" + first->desc->name + "' a `bypass` for '" + name +
                                         "', or the reader the same `when`";
        return;
    }
    std::vector<Place> deletions;
    for (const Named& each : state.description.deleted) {
        if (each.pointer.compare(0, 7, "/passes") != 0) continue;
        error.notes.push_back({each.place, "'" + each.name + "' was deleted here"});
        deletions.push_back(each.place);
    }
    if (deletions.size() == 1)
        error.help = "leave the null out, or name another target in `inputs` of the reader";
    if (isModule(at.place))
        blame(error, deletions.size() == 1 ? deletions.front() : ownPlace(at.place),
              "it is read here");
}

// Where the config makes the pass read through this sampler.
Reference placeOf(const Pass& pass, const Read& read)
{
    if (read.name.empty()) return pass.desc->mask;
    if (!read.input) return {{read.name, pass.desc->place, pass.desc->pointer}};
    return read.input->from.empty() ? *read.input : read.input->from;
}

// Walks back from an undone pass until one comes up again, and reports the cycle.
std::vector<int> reportCycle(State& state, const Edges& edges, const std::vector<bool>& done)
{
    std::vector<int> path;
    int at = static_cast<int>(std::find(done.begin(), done.end(), false) - done.begin());
    while (!std::count(path.begin(), path.end(), at)) {
        path.push_back(at);
        const auto undone = [&done](const Edge& edge) { return !done[edge.from]; };
        at = std::find_if(edges[at].begin(), edges[at].end(), undone)->from;
    }
    path.erase(path.begin(), std::find(path.begin(), path.end(), at));
    std::reverse(path.begin(), path.end());  // now along the data
    std::rotate(path.begin(), std::min_element(path.begin(), path.end()), path.end());

    std::string way = state.passes[path[0]].desc->name;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const int next = path[(i + 1) % path.size()];
        const auto ours = [&](const Edge& edge) { return edge.from == path[i]; };
        const Edge& edge = *std::find_if(edges[next].begin(), edges[next].end(), ours);
        way += " -> " + state.passes[next].desc->name + " (" + nameOf(state, edge.target) + ")";
    }
    Diagnostic& error = report(state, Code::cycle, "passes wait for each other: " + way,
                               *state.passes[path[0]].desc, "let one of them read another target");
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Pass& pass = state.passes[path[i]];
        error.notes.push_back({pass.desc->place, quoted(pass) + " is here"});
    }
    return path;
}

Source targetNamed(const State& state, const std::string& name)
{
    return {InputKind::target, indexOf(state.description.targets, name)};
}

void addEdge(State& state, int index, const Source& source, const Reference& at, Edges& edges)
{
    const Pass& pass = state.passes[index];
    const std::optional<Source> behind = resolve(state, source);
    if (!behind) return reportNeverWritten(state, quoted(pass), source.index, at);
    if (behind->kind != InputKind::target) return;
    const int writer = state.targets[behind->index].writer;
    if (writer == index)
        report(state, Code::reads_own_output,
               quoted(pass) + " reads target '" + nameOf(state, behind->index) + "' and writes it",
               at, "write to another target, or read another one");
    else
        edges[index].push_back({writer, behind->index});
}

// That a pass has what it draws, and one of a box nothing that changes with the camera.
void checkSeen(State& state, const Pass& pass, const std::vector<Edge>& reads)
{
    const auto has_draws = [](const ImportDesc& each) {
        return each.type == ImportType::draw_list;
    };
    if (pass.desc->type == PassType::draw && !anyOf(state.description.imports, has_draws))
        report(state, Code::no_draw_list, quoted(pass) + " draws the scene, which nothing imports",
               *pass.desc, "add \"imports\": { \"scene\": { \"type\": \"draw_list\" } }");
    const Reference& box = pass.desc->box;
    for (const Edge& read : reads) {
        const Pass& writer = state.passes[read.from];
        if (box.name.empty() || !writer.desc->box.name.empty()) continue;
        report(state, Code::box_input,
               quoted(pass) + " is drawn when the box '" + box.name +
                   "' changes, and reads target '" + nameOf(state, read.target) + "', which " +
                   quoted(writer) + " draws by the camera",
               box, "leave `box` off: to read what passes of boxes have drawn none is needed");
        return;
    }
}

// What a no-op gives is waited for as what a sampler reads is, whether the no-op holds or
// not: so leaving the pass out can only make the graph smaller.
void addEdges(State& state, int index, Edges& edges)
{
    const Pass& pass = state.passes[index];
    if (pass.over >= 0) edges[index].push_back({pass.over, pass.color.front()});
    for (const Read& read : pass.reads)
        addEdge(state, index, read.named, placeOf(pass, read), edges);
    for (const NoOpDesc& no_op : pass.desc->no_op)
        for (const NoOpDesc::Gives& gives : no_op.gives)
            if (!gives.constant)
                addEdge(state, index, targetNamed(state, gives.input.name), gives.input, edges);
    checkSeen(state, pass, edges[index]);
}

void checkOutputs(State& state)
{
    for (const int index : state.outputs) {
        const OutputDesc& output = state.description.outputs[index];
        const int target = indexOf(state.description.targets, output.target.name);
        if (!resolveTarget(state, target))
            reportNeverWritten(state, "output '" + output.name + "'", target, output.target);
    }
}

void reportTwoWriters(State& state, const Pass& pass, const std::string& does, const Reference& at,
                      const Pass& writer)
{
    Diagnostic& error = report(
        state, Code::two_writers,
        quoted(pass) + " " + does + " '" + at.name + "', which " + quoted(writer) + " writes", at,
        "write to a target of its own, or give the passes conditions that exclude each other");
    error.notes.push_back({referenceTo(writer, at.name).place, "the first writer"});
    blame(error, ownPlace(error.place), "the second writer");
}

// A target that one pass writes and another one, which is off, passes on: two chains with one end.
void checkBypasses(State& state)
{
    for (const Pass& pass : state.passes) {
        if (pass.active) continue;
        for (const BypassDesc& bypass : pass.desc->bypass) {
            const int target = indexOf(state.description.targets, bypass.name);
            const int writer = target < 0 ? -1 : state.targets[target].writer;
            if (writer >= 0)
                reportTwoWriters(state, pass, "passes on, while it is off,", bypass,
                                 state.passes[writer]);
        }
    }
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

// Whether each target that the no-op gives for another one is stored as that is.
bool givesAlike(const State& state, const NoOpDesc& no_op)
{
    return allOf(no_op.gives, [&](const NoOpDesc::Gives& each) {
        const int replaced = indexOf(state.description.targets, each.name);
        const int by = indexOf(state.description.targets, each.input.name);
        return each.constant || replaced < 0 || by < 0 ||
               storedAlike(state.targets[replaced].format, state.targets[by].format);
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
    const auto need = [&](Pass& pass) {
        if (pass.live) return;
        pass.live = true;
        for (const Read& read : pass.reads) work.push_back(read.named);
        if (pass.over < 0) return;
        Pass& under = state.passes[pass.over];
        under.live = true;
        for (const Read& read : under.reads) work.push_back(read.named);
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
    const auto missed = [](const Pass& pass) { return pass.live && pass.replaced(); };
    const auto at = std::find_if(state.passes.begin(), state.passes.end(), missed);
    return at == state.passes.end() ? -1 : static_cast<int>(at - state.passes.begin());
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

void findWriters(State& state)
{
    for (std::size_t i = 0; i < state.passes.size(); ++i) {
        const Pass& pass = state.passes[i];
        if (!pass.active) continue;
        for (const int index : writtenBy(pass)) {
            int& writer = state.targets[index].writer;
            const bool under = writer >= 0 && drawsOver(state, state.passes[writer], index) &&
                               state.passes[writer].over == static_cast<int>(i);
            if (under) continue;
            if (writer >= 0 && !(drawsOver(state, pass, index) && writer == pass.over))
                reportTwoWriters(state, pass, "writes target",
                                 referenceTo(pass, nameOf(state, index)), state.passes[writer]);
            else
                writer = static_cast<int>(i);
        }
    }
    checkBypasses(state);
}

void orderPasses(State& state)
{
    Edges edges(state.passes.size());
    std::vector<bool> done(state.passes.size());
    for (std::size_t i = 0; i < state.passes.size(); ++i) {
        done[i] = !state.passes[i].active;
        if (!done[i]) addEdges(state, static_cast<int>(i), edges);
    }
    checkOutputs(state);

    const auto ready = [&](std::size_t i) {
        return !done[i] && allOf(edges[i], [&](const Edge& edge) { return done[edge.from]; });
    };
    while (std::count(done.begin(), done.end(), false) > 0) {
        std::size_t next = 0;
        while (next < done.size() && !ready(next)) ++next;
        std::vector<int> taken = {static_cast<int>(next)};
        if (next == done.size()) taken = reportCycle(state, edges, done);
        for (const int index : taken) {
            done[index] = true;
            state.order.push_back(index);
        }
    }
}

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

// Of active passes, those that outputs on request need.
std::set<std::string> namesOnRequest(const State& state)
{
    std::set<std::string> passes, targets;
    for (const OutputDesc& output : state.description.outputs)
        if (output.on_request) targets.insert(output.target.name);
    for (auto index = state.order.rbegin(); index != state.order.rend(); ++index) {
        const Pass& pass = state.passes[*index];
        if (!anyOf(writtenBy(pass), [&](int at) { return targets.count(nameOf(state, at)) > 0; }))
            continue;
        passes.insert(pass.desc->name);
        for (const Read& read : pass.reads)
            if (read.named.isTarget()) targets.insert(nameOf(state, read.named.index));
    }
    return passes;
}

void lintDeadPasses(State& state)
{
    // Where something was asked for, or something stands in, that is what leaves passes out.
    const bool reduced = anyOf(state.passes, [](const Pass& pass) { return pass.replaced(); });
    if (reduced || !state.options.outputs.empty() || hasErrors(state.diagnostics)) return;
    const std::set<std::string> on_request = namesOnRequest(state);
    for (const Pass& pass : state.passes)
        if (pass.active && !pass.live && on_request.count(pass.desc->name) == 0)
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
    for (Pass& pass : state.passes) {
        pass.over = indexOf(state.description.passes, pass.desc->over.name);
        if (pass.over < 0 || state.passes[pass.over].active || !pass.active) continue;
        pass.active = false;
        pass.off_reason = quoted(state.passes[pass.over]) + ", which it draws over, is off";
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
