// SPDX-License-Identifier: MIT
// The graph: who writes what, and in which order passes run.
#include "core/compile/steps.h"

#include "core/base/text.h"

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
    if (!read.input) return {read.name, pass.desc->place, pass.desc->pointer};
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

// What a no-op gives is waited for as what a sampler reads is, whether the no-op holds or
// not: so leaving the pass out can only make the graph smaller.
void addEdges(State& state, int index, Edges& edges)
{
    const Pass& pass = state.passes[index];
    for (const Read& read : pass.reads)
        addEdge(state, index, read.named, placeOf(pass, read), edges);
    for (const NoOpDesc& no_op : pass.desc->no_op) {
        for (const NoOpDesc::Gives& gives : no_op.gives) {
            if (gives.constant) continue;
            const int target = indexOf(state.description.targets, gives.input.name);
            addEdge(state, index, {InputKind::target, target}, gives.input, edges);
        }
    }
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
        "write to a target of its own, or give the passes conditions that exclude each "
        "other");
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

}  // namespace

void findWriters(State& state)
{
    for (std::size_t i = 0; i < state.passes.size(); ++i) {
        const Pass& pass = state.passes[i];
        if (!pass.active) continue;
        for (const int index : writtenBy(pass)) {
            Target& target = state.targets[index];
            if (target.writer < 0)
                target.writer = static_cast<int>(i);
            else
                reportTwoWriters(state, pass, "writes target",
                                 referenceTo(pass, nameOf(state, index)),
                                 state.passes[target.writer]);
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

}  // namespace crevice::compiler
