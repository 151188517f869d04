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
        if (samplingOf(read).filter != Filter::linear) continue;
        const std::optional<Source> source = resolve(state, read.named);
        if (!source || !source->isTarget()) continue;
        const FormatInfo& format = formatInfo(state.targets[source->index].format);
        if (format.filterable) continue;
        report(state, Code::cannot_filter,
               quoted(pass) + " reads '" + read.sampler + "' with the filter linear, and " +
                   format.name + " of target '" + nameOf(state, source->index) +
                   "' cannot be filtered: it would read as black",
               read.input->sampler,
               "read it with the filter nearest, or give the target a format that filters: r8, "
               "r16f, rgba8, rgba16f");
    }
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
    for (const Pass& pass : state.passes)
        if (pass.active && !pass.live)
            report(state, Code::dead_pass,
                   quoted(pass) + " does not run: no output needs what it writes", *pass.desc,
                   "read what it writes, export it under `outputs`, or leave out the module")
                .severity = Severity::warning;
}

}  // namespace crevice::compiler
