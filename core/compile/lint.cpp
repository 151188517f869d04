// SPDX-License-Identifier: MIT
// What a device would run without a word, and draw nothing good: linear reads of formats that it
// does not mix, and passes whose work nobody looks at.
#include "core/compile/steps.h"

#include <algorithm>

namespace crevice::compiler {

namespace {

void checkSampling(State& state, const Pass& pass)
{
    for (const Read& read : pass.reads) {
        if (!read.input || !read.input->has_filter || read.input->filter != Filter::linear)
            continue;
        const std::optional<Source> source = resolve(state, read.named);
        const bool target =
            source && (source->kind == InputKind::target || source->kind == InputKind::history);
        if (!target || formatInfo(state.targets[source->index].format).filterable) continue;
        const std::string format = formatInfo(state.targets[source->index].format).name;
        Diagnostic& error = report(state, Code::cannot_filter,
                                   "pass '" + pass.desc->name + "' reads '" + read.sampler +
                                       "' with the filter linear, and " + format + " of target '" +
                                       state.description.targets[source->index].name +
                                       "' cannot be filtered: it would read as black",
                                   read.input->sampler);
        error.help =
            "read it with the filter nearest, or give the target a format that filters: r8, "
            "r16f, rgba8, rgba16f";
    }
}

void warnUnread(State& state, const Pass& pass)
{
    if (!pass.active || pass.live) return;
    Diagnostic& warning = report(
        state, Code::dead_pass,
        "pass '" + pass.desc->name + "' does not run: no output needs what it writes", *pass.desc);
    warning.severity = Severity::warning;
    warning.help = "read what it writes, export it under `outputs`, or leave out the module";
}

}  // namespace

void lint(State& state)
{
    for (const Pass& pass : state.passes)
        if (pass.active && pass.live) checkSampling(state, pass);
    // Where something was asked for, or something stands in, that is what leaves passes out.
    const bool reduced = std::any_of(state.passes.begin(), state.passes.end(),
                                     [](const Pass& pass) { return pass.replaced(); });
    if (reduced || !state.options.outputs.empty() || hasErrors(state.diagnostics)) return;
    for (const Pass& pass : state.passes) warnUnread(state, pass);
}

}  // namespace crevice::compiler
