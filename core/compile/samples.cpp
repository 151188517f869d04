// SPDX-License-Identifier: MIT
// Samples: how many each pass draws a pixel with. All attachments of a pass have as many.
#include "core/compile/steps.h"

#include "core/base/text.h"

namespace crevice::compiler {

namespace {

std::string text(int samples)
{
    return std::to_string(samples) + (samples == 1 ? " sample" : " samples");
}

// The least count that is no less than was asked for, or else the most.
int nearestCount(std::uint32_t counts, int asked)
{
    const auto has = [counts](int samples) { return (counts >> (samples - 1) & 1u) != 0; };
    for (int samples = asked; samples <= kMaxSamples; ++samples)
        if (has(samples)) return samples;
    for (int samples = asked - 1; samples > 1; --samples)
        if (has(samples)) return samples;
    return 1;
}

void choose(State& state, const Pass& pass, const std::vector<int>& written)
{
    const int asked = askedSamples(state, written.front());
    if (asked == 1) return;
    std::uint32_t counts = ~0u;
    std::vector<std::string> formats;
    for (const int index : written) {
        const Target& target = state.targets[index];
        if (!target.textured) continue;
        counts &= state.caps.sample_counts[static_cast<int>(target.format)];
        formats.push_back(formatInfo(target.format).name);
    }
    const int count = nearestCount(counts, asked);
    for (const int index : written) state.targets[index].samples = count;
    if (count >= asked || !pass.live) return;
    report(state, Code::no_samples,
           quoted(pass) + " falls back from " + text(asked) + " a pixel to " +
               std::to_string(count) + ": the device draws no more into " + joined(formats),
           *pass.desc)
        .severity = Severity::warning;
}

}  // namespace

int askedSamples(const State& state, int target)
{
    const TargetDesc& desc = state.description.targets[target];
    const ParamDesc* param = findNamed(state.description.params, desc.samples_param.name);
    return param ? static_cast<int>(param->value[0]) : desc.samples;
}

void chooseSamples(State& state)
{
    for (const Pass& pass : state.passes) {
        const std::vector<int> written = writtenBy(pass);
        if (!pass.active || written.empty()) continue;
        const auto asked = [&](int target) {
            return "has " + text(askedSamples(state, target)) + " a pixel";
        };
        if (attachmentsAgree(state, pass, Code::attachment_samples, "samples", asked))
            choose(state, pass, written);
    }
}

}  // namespace crevice::compiler
