// SPDX-License-Identifier: MIT
// Fusion of passes: where one only prepares, pixel by pixel, what one other pass samples at that pixel, the
// other does both, and the texture between them is not there.
//
// Passes that look about themselves, filters for one, stay: their readers may run again where they need not,
// under a moving light.
#include "core/compile_steps.h"

#include "core/glsl_fuse.h"
#include "core/glsl_scan.h"

#include <algorithm>

namespace crevice::compiler {

namespace {

// What a texture of that format makes of `highp vec4 v`; empty where devices round it one way or another, as
// they do to halves. Mesa multiplies eight bits by the reciprocal, as here; who divides gets another last bit of
// a float.
std::string storedAs(Format format)
{
    const FormatInfo& info = formatInfo(format);
    const bool eight_bits = info.format_class == FormatClass::unorm && info.absolute_step == 1.0 / 255;
    const bool whole = info.format_class == FormatClass::floating && info.bytes == 4 * info.channels;
    if (eight_bits) return "roundEven(clamp(v, 0.0, 1.0) * 255.0) * (1.0 / 255.0)";
    return whole ? "v" : "";
}

// A pass that reads a target, and by which sampler.
struct Reading {
    int pass = -1;
    int read = -1;
};

bool isTarget(const std::optional<Source>& source, int target)
{
    return source && source->kind == InputKind::target && source->index == target;
}

// Whether the pass runs, or would with params of other values.
bool mayRun(const State& state, const Pass& pass)
{
    const std::vector<int> written = writtenBy(pass);
    const auto wanted = [&](int target) { return state.targets[target].wanted; };
    return pass.live ||
           (pass.active && pass.fused_into < 0 && std::any_of(written.begin(), written.end(), wanted));
}

// The one reading of the target; none where there may be more, or an output or the next frame wants it too. A param
// must not decide, for it would compile shaders.
std::optional<Reading> onlyReading(const State& state, int target)
{
    if (state.targets[target].remembered) return std::nullopt;
    for (const int output : state.outputs) {
        const std::string& name = state.description.outputs[output].target.name;
        if (isTarget(resolveTarget(state, indexOf(state.description.targets, name)), target)) return std::nullopt;
    }
    std::optional<Reading> found;
    for (const int index : state.order) {
        const Pass& pass = state.passes[index];
        for (std::size_t i = 0; mayRun(state, pass) && i < pass.reads.size(); ++i) {
            const Source& named = pass.reads[i].named;
            const bool direct = isTarget(named, target);
            if (!direct && !isTarget(resolve(state, named), target)) continue;
            if (found || !direct || !pass.live) return std::nullopt;
            found = Reading{index, static_cast<int>(i)};
        }
    }
    return found;
}

// Whether it is a fullscreen pass with nothing about it but its shader, whatever values params have.
bool isPlain(const State& state, const Pass& pass)
{
    const PassDesc& desc = *pass.desc;
    return pass.live && pass.shader >= 0 && desc.type == PassType::fullscreen &&
           desc.state.blend == Blend::none && desc.state.depth_test == Compare::always &&
           desc.state.cull == Cull::none && pass.depth < 0 && samplesOf(state, pass) == 1 &&
           desc.identity.empty() && desc.keeps_constant.empty();
}

bool hasLevels(const State& state, const Read& read)
{
    const std::optional<Source> source = resolve(state, read.named);
    const bool target = source && (source->kind == InputKind::target || source->kind == InputKind::history);
    return target && state.description.targets[source->index].mips != 1;
}

// Whether the pass draws each of its pixels, into one target and nothing else, from textures of one level.
bool mayWrite(const State& state, const Pass& pass)
{
    const auto levels = [&](const Read& read) { return hasLevels(state, read); };
    return isPlain(state, pass) && pass.color.size() == 1 && state.targets[pass.color.front()].textured &&
           state.description.targets[pass.color.front()].mips == 1 && !readsMask(pass) && !pass.desc->bounded &&
           pass.desc->uniforms.empty() && std::none_of(pass.reads.begin(), pass.reads.end(), levels);
}

bool sampleAlike(const State& state, const Read& a, const Read& b)
{
    const SamplerDesc first = samplingOf(a);
    const SamplerDesc second = samplingOf(b);
    const std::optional<Source> from = resolve(state, a.named);
    const std::optional<Source> to = resolve(state, b.named);
    return from && to && from->kind == to->kind && from->index == to->index && from->value == to->value &&
           first.filter == second.filter && first.wrap == second.wrap;
}

// What the reader reads once it does the writer's work too; nothing where one sampler would have two textures.
std::optional<std::vector<Read>> joinedReads(const State& state, const Pass& writer, const Pass& reader,
                                             int seam)
{
    std::vector<Read> reads = writer.reads;
    for (std::size_t i = 0; i < reader.reads.size(); ++i) {
        const Read& read = reader.reads[i];
        if (static_cast<int>(i) == seam) continue;
        const auto same = [&](const Read& other) { return other.sampler == read.sampler; };
        const auto other = std::find_if(writer.reads.begin(), writer.reads.end(), same);
        if (other == writer.reads.end()) reads.push_back(read);
        else if (!sampleAlike(state, *other, read)) return std::nullopt;
    }
    const bool fits = static_cast<int>(reads.size()) <= state.caps.max_texture_units;
    return fits ? std::optional(std::move(reads)) : std::nullopt;
}

// Whether uniforms of the writer, by their own names, would be others in the reader.
bool renamesAny(const Pass& reader, const GlslStage& writer)
{
    const auto& renames = reader.desc->uniforms;
    return std::any_of(renames.begin(), renames.end(),
                       [&](const auto& rename) { return declares(writer, rename.first.name); });
}

// Whether the reader, as far as its surroundings tell, samples the very pixel that the writer draws.
bool meet(const State& state, const Pass& writer, const Pass& reader, const Read& seam)
{
    return isPlain(state, reader) && samplingOf(seam).filter == Filter::nearest &&
           extentOf(state, writer) == extentOf(state, reader) &&
           state.shaders[writer.shader].vertex.text == state.shaders[reader.shader].vertex.text &&
           !renamesAny(reader, state.shaders[writer.shader].fragment);
}

std::optional<GlslStage> fusedStage(const State& state, const Pass& writer, const Pass& reader, const Read& seam)
{
    const Shader& shader = state.shaders[writer.shader];
    const Format format = state.targets[writer.color.front()].format;
    const std::string stored = storedAs(format);
    if (stored.empty()) return std::nullopt;
    std::optional<GlslStage> fused = fuse(shader.fragment, state.shaders[reader.shader].fragment,
                                          {writer.desc->name, seam.sampler, spanningOutput(shader.vertex),
                                           formatInfo(format).channels, stored});
    const bool fits = fused && vectorsOf(*fused) <= state.caps.max_fragment_uniform_vectors;
    return fits ? std::move(fused) : std::nullopt;
}

// Makes one pass of this one and its reader, where that is the same.
void fuseWithReader(State& state, int index)
{
    Pass& writer = state.passes[index];
    if (!mayWrite(state, writer)) return;
    const std::optional<Reading> reading = onlyReading(state, writer.color.front());
    if (!reading) return;
    Pass& reader = state.passes[reading->pass];
    const Read& seam = reader.reads[reading->read];
    if (!meet(state, writer, reader, seam)) return;
    std::optional<std::vector<Read>> reads = joinedReads(state, writer, reader, reading->read);
    std::optional<GlslStage> fused = reads ? fusedStage(state, writer, reader, seam) : std::nullopt;
    if (!fused) return;
    state.shaders.push_back({true, true, state.shaders[reader.shader].vertex, std::move(*fused)});
    reader.shader = static_cast<int>(state.shaders.size()) - 1;
    reader.reads = std::move(*reads);
    reader.fused.push_back(index);
    writer.live = false;
    writer.fused_into = reading->pass;
    state.targets[writer.color.front()].textured = false;
}

}  // namespace

void fusePasses(State& state)
{
    if (!state.applies("fusion")) return;
    // From the last on, so that a chain ends up in the pass at its end.
    for (auto index = state.order.rbegin(); index != state.order.rend(); ++index) fuseWithReader(state, *index);
}

}  // namespace crevice::compiler
