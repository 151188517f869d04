// SPDX-License-Identifier: MIT
// Samplers: the target, texture or import behind each, and renames of what no shader has.
#include "core/compile/steps.h"

#include "core/base/text.h"
#include "core/frame/frame_values.h"
#include "core/sampling/generators.h"

#include <algorithm>

namespace crevice::compiler {

namespace {

const InputDesc* inputFor(const PassDesc& pass, std::string_view sampler)
{
    for (const InputDesc& input : pass.inputs)
        if (input.sampler.name == sampler) return &input;
    return nullptr;
}

// The texture of that name, as the pass sees it.
std::optional<Source> sourceNamed(const State& state, const PassDesc& pass, std::string_view name)
{
    const Description& description = state.description;
    if (const int i = indexOf(description.targets, name); i >= 0)
        return Source{InputKind::target, i};
    for (std::size_t i = 0; i < description.targets.size(); ++i)
        if (description.targets[i].history && historyName(description.targets[i]) == name)
            return Source{InputKind::history, static_cast<int>(i)};
    if (const int i = indexOf(description.generated, name); i >= 0)
        if (generatesTexture(description.generated[i].generator))
            return Source{InputKind::generated, i};
    if (const int i = indexOf(description.imports, name); i >= 0)
        if (description.imports[i].type == ImportType::texture)
            return Source{InputKind::imported, i};
    if (const int i = indexOf(kMaterialMaps, name); i >= 0 && pass.type == PassType::draw)
        return Source{InputKind::material, i};
    return std::nullopt;
}

std::vector<std::string> texturesOf(const State& state)
{
    std::vector<std::string> names = namesOf(state.description.targets);
    for (const TargetDesc& each : state.description.targets)
        if (each.history) names.push_back(historyName(each));
    for (const GeneratedDesc& each : state.description.generated)
        if (generatesTexture(each.generator)) names.push_back(each.name);
    for (const ImportDesc& each : state.description.imports)
        if (each.type == ImportType::texture) names.push_back(each.name);
    return names;
}

// Whether any GLSL has the word, also where an #if hides it.
bool isMentioned(const State& state, std::string_view word)
{
    const auto& files = state.description.files;
    return std::any_of(files.begin(), files.end(), [&](const auto& file) {
        return findWord(file.second->text, word) != std::string::npos;
    });
}

// Checks a name of the shader's by which the pass says `what`, and that `from` is not meant.
void checkMentioned(State& state, const Pass& pass, const Reference& name, const Reference& from,
                    const char* what)
{
    const ShaderDesc& shader = state.description.shaders[pass.shader];
    if (isMentioned(state, name.name)) return;
    std::vector<std::string> names;
    for (const GlslStage* stage :
         {&state.shaders[pass.shader].vertex, &state.shaders[pass.shader].fragment})
        for (const GlslUniform& uniform : stage->uniforms) names.push_back(uniform.name);
    std::string help = suggestName(name.name, names, "the shader declares");
    const bool same = std::count(names.begin(), names.end(), from.name) > 0;
    if (same && help.find("did you mean") == std::string::npos)
        help = "did you mean '" + from.name + "'? " + help;
    report(state, Code::input_unused,
           quoted(pass) + " " + what + " '" + name.name + "', which shader '" + shader.name +
               "' does not have",
           name, help);
}

// Samples come from the host alone: targets are resolved before anyone reads them.
void checkMultisampled(State& state, const Pass& pass, const GlslUniform& uniform,
                       const Source& source)
{
    if (uniform.type != GlslType::sampler2d_ms) return;
    const std::string who = quoted(pass) + ": sampler '" + uniform.name + "' ";
    const bool imported = source.kind == InputKind::imported;
    if (state.caps.version < 310) {
        reportGlsl(
            state, Code::sampler_version,
            who +
                "reads samples one by one, which needs OpenGL ES 3.1, and the device has "
                "3.0",
            pass, uniform.place,
            "let the host resolve its texture (glBlitFramebuffer takes one sample of depth) and "
            "take a module for one sample a pixel: geometry/host_depth");
    } else if (!imported) {
        reportGlsl(state, Code::uniform_type,
                   who + "is a sampler2DMS, and what it reads has one sample a pixel", pass,
                   uniform.place,
                   "declare it as sampler2D: what has several is resolved before it is read");
    } else if (const ImportDesc& import = state.description.imports[source.index];
               import.optional) {
        report(state, Code::uniform_type,
               who + "is a sampler2DMS, and nothing can stand in for import '" + import.name +
                   "' when it is absent",
               import, "leave out its 'optional'");
    }
}

}  // namespace

void readSampler(State& state, Pass& pass, const GlslUniform& uniform)
{
    for (const Read& read : pass.reads)
        if (read.sampler == uniform.name) return;  // declared in both stages
    if (uniform.array) {
        reportGlsl(state, Code::uniform_type,
                   quoted(pass) + ": '" + uniform.name +
                       "' is an array of samplers, which nothing can fill",
                   pass, uniform.place, "declare one sampler2D for each texture");
        return;
    }
    const InputDesc* input = inputFor(*pass.desc, uniform.name);
    const std::string& name = input && !input->from.empty() ? input->from.name : uniform.name;
    const auto source = sourceNamed(state, *pass.desc, name);
    if (source) {
        checkMultisampled(state, pass, uniform, *source);
        pass.reads.push_back({uniform.name, input, *source});
        return;
    }
    reportUnbound(state,
                  quoted(pass) + ": sampler '" + uniform.name + "' reads '" + name +
                      "', which is no target, generated texture or import",
                  pass, uniform, name, suggestName(name, texturesOf(state), "textures"));
}

void reportUnbound(State& state, std::string message, const Pass& pass, const GlslUniform& uniform,
                   const std::string& name, std::string help)
{
    Diagnostic& error = reportGlsl(state, Code::uniform_unbound, std::move(message), pass,
                                   uniform.place, std::move(help));
    for (const Named& each : state.description.deleted)
        if (each.name == name) error.notes.push_back({each.place, "it was deleted here"});
}

void checkInputs(State& state, const Pass& pass)
{
    for (const InputDesc& input : pass.desc->inputs)
        checkMentioned(state, pass, input.sampler, input.from, "renames input");
    for (const PreservesConstantDesc& each : pass.desc->preserves_constant)
        checkMentioned(state, pass, each.sampler, each.sampler,
                       "preserves the constant of sampler");
}

SamplerDesc samplingOf(const Read& read)
{
    const bool material = read.named.kind == InputKind::material;
    const bool tiled = material || read.named.kind == InputKind::generated;
    SamplerDesc sampling = {material ? Filter::linear : Filter::nearest,
                            tiled ? Wrap::repeat : Wrap::clamp};
    if (read.input && read.input->has_filter) sampling.filter = read.input->filter;
    if (read.input && read.input->has_wrap) sampling.wrap = read.input->wrap;
    return sampling;
}

bool readsMask(const Pass& pass)
{
    return std::any_of(pass.reads.begin(), pass.reads.end(),
                       [](const Read& read) { return read.sampler.empty(); });
}

}  // namespace crevice::compiler
