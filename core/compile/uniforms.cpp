// SPDX-License-Identifier: MIT
// Uniforms: the texture, param, kernel or frame value behind each, and how many the device holds.
#include "core/compile/steps.h"

#include "core/config/values.h"
#include "core/frame/frame_math.h"
#include "core/sampling/generators.h"

namespace crevice::compiler {
namespace {

// What a name in GLSL stands for, and what a uniform of that name has to look like.
struct Supply {
    const char* what;
    GlslType type;
    int count;         // 0: no array
    int index;         // into its list in the description, or kFrameValues
    Place place = {};  // in the config
    UniformSource source = UniformSource::param;
    InputKind kind = InputKind::target;  // of a texture
};

std::optional<Supply> supplyOf(const Description& description, const PassDesc& pass,
                               std::string_view name)
{
    const auto texture = [](const char* what, InputKind kind, int index, const Place& place = {}) {
        return Supply{what, GlslType::sampler2d, 0, index, place, UniformSource::param, kind};
    };
    if (const int i = indexOf(description.params, name); i >= 0) {
        const ParamDesc& param = description.params[i];
        return Supply{"param", glslTypeOf(param.type), 0, i, param.place};
    }
    if (const int i = indexOf(description.generated, name); i >= 0) {
        const GeneratedDesc& each = description.generated[i];
        if (generatesTexture(each.generator))
            return texture("generated texture", InputKind::generated, i, each.place);
        const int count = generatedCount(description, each);
        return Supply{"kernel", GlslType::vec3, count, i, each.place, UniformSource::kernel};
    }
    for (std::size_t i = 0; i < description.targets.size(); ++i) {
        const TargetDesc& each = description.targets[i];
        const int index = static_cast<int>(i);
        if (each.name == name) return texture("target", InputKind::target, index, each.place);
        if (each.history && historyName(each) == name)
            return texture("history", InputKind::history, index, each.place);
    }
    if (const int i = indexOf(description.imports, name); i >= 0)
        if (const ImportDesc& each = description.imports[i]; each.type == ImportType::texture)
            return texture("texture import", InputKind::imported, i, each.place);
    const bool draws = pass.type == PassType::draw;
    if (const int i = indexOf(kMaterialMaps, name); i >= 0 && draws)
        return texture("material's map", InputKind::material, i);
    const FrameValueInfo* value = findNamed(kFrameValues, name);
    const bool of_draw = value && value->import == ImportType::draw_list;
    if (!value || (of_draw && !draws)) return std::nullopt;
    return Supply{"value of the frame",
                  value->type,
                  value->count > 1 ? value->count : 0,
                  static_cast<int>(value - kFrameValues),
                  {},
                  of_draw ? UniformSource::draw : UniformSource::frame};
}

std::string spell(const std::string& type, std::string_view name, int count)
{
    const std::string text = type + " " + std::string(name);
    return count > 0 ? text + "[" + std::to_string(count) + "]" : text;
}

// What a uniform may be called that is no sampler.
std::vector<std::string> valueNames(const Description& description, const PassDesc& pass)
{
    std::vector<std::string> names = namesOf(description.params);
    for (const GeneratedDesc& each : description.generated)
        if (!generatesTexture(each.generator)) names.push_back(each.name);
    for (const FrameValueInfo& each : kFrameValues)
        if (each.import != ImportType::draw_list || pass.type == PassType::draw)
            names.push_back(each.name);
    return names;
}

// One for each scalar, vector, array element and column of a matrix.
int vectorsOf(const GlslStage& stage)
{
    int vectors = 0;
    for (const GlslUniform& uniform : stage.uniforms) {
        if (isSampler(uniform.type)) continue;
        const GlslType type = uniform.type;
        const int each = type == GlslType::mat4 ? 4 : type == GlslType::mat3 ? 3 : 1;
        vectors += each * uniform.count;
    }
    return vectors;
}

// Blames the kernel that need only be shorter, or the param that gives its count; else the pass.
void checkVectors(State& state, const Pass& pass, const GlslStage& stage, const char* name,
                  int limit)
{
    const int vectors = vectorsOf(stage);
    if (vectors <= limit) return;
    Diagnostic& error =
        report(state, Code::too_many,
               quoted(pass) + ": the " + name + " shader has " + std::to_string(vectors) +
                   " uniform vectors, and the device holds " + std::to_string(limit),
               *pass.desc, "ask for fewer samples or lights, or fewer uniforms");
    for (const GlslUniform& uniform : stage.uniforms) {
        const GeneratedDesc* kernel = findNamed(state.description.generated, uniform.name);
        const int most = uniform.count - (vectors - limit);
        if (!kernel || most < 1) continue;
        const ParamDesc* param = findNamed(state.description.params, kernel->count_param.name);
        const Named& at = param ? static_cast<const Named&>(*param) : *kernel;
        error.place = at.place;
        error.pointer = at.pointer;
        error.help = "lower " + (param ? "'" + param->name + "'" : std::string("its `count`")) +
                     " to " + std::to_string(most);
    }
}

// Nothing is called `name`, which the uniform wants.
void reportUnbound(State& state, const Pass& pass, const GlslUniform& uniform,
                   const std::string& name)
{
    const bool texture = isSampler(uniform.type);
    const bool draws_only = !texture && findNamed(kFrameValues, name) != nullptr;
    const std::string what = texture ? "sampler '" + uniform.name + "' reads '" + name +
                                           "', which is no target, generated texture or import"
                                     : "uniform '" + name +
                                           (draws_only ? "' has a value in draw passes only"
                                                       : "' is supplied by nothing");
    const std::string help =
        draws_only ? "make the pass a draw, or drop the uniform"
                   : suggestName(name,
                                 texture ? textureNames(state.description)
                                         : valueNames(state.description, *pass.desc),
                                 texture ? "textures" : "values") +
                         "; or declare it under '" + (texture ? "targets'" : "params'");
    Diagnostic& error = reportGlsl(state, Code::uniform_unbound, quoted(pass) + ": " + what, pass,
                                   uniform.place, help);
    for (const Named& each : state.description.deleted)
        if (each.name == name) error.notes.push_back({each.place, "it was deleted here"});
}

void reportShape(State& state, const Pass& pass, const GlslUniform& uniform, const Supply& supply)
{
    const std::string wanted = spell(glslName(supply.type), uniform.name, supply.count);
    Diagnostic& error =
        reportGlsl(state, Code::uniform_type,
                   quoted(pass) + ": uniform '" + uniform.name + "' is declared as " +
                       spell(uniform.spelling, uniform.name, uniform.array ? uniform.count : 0) +
                       ", and the " + supply.what + " is " + wanted,
                   pass, uniform.place, "declare: uniform " + wanted + ";");
    if (supply.place.source) error.notes.push_back({supply.place, "the config declares it here"});
}

// Samples come from the host alone: targets are resolved before anyone reads them.
void checkMultisampled(State& state, const Pass& pass, const GlslUniform& uniform,
                       const Source& source)
{
    if (uniform.type != GlslType::sampler2d_ms) return;
    const std::string who = quoted(pass) + ": sampler '" + uniform.name + "' ";
    const bool imported = source.kind == InputKind::imported;
    if (state.caps.version < 310) {
        report(state, Code::sampler_version,
               who + "reads samples one by one, which needs OpenGL ES 3.1, and the device has 3.0",
               pass.desc->shader,
               "let the host resolve its texture (glBlitFramebuffer takes one sample of depth) and "
               "take a module for one sample a pixel: geometry/host_depth")
            .notes.push_back({uniform.place, "the GLSL declares it here"});
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

std::string declarationOf(const Description& description, const std::string& name)
{
    const std::optional<Supply> supply = supplyOf(description, PassDesc(), name);
    if (!supply) return {};
    const ParamDesc* param = findNamed(description.params, name);
    return std::string("it is a ") + supply->what + ": write " +
           (param && param->bind == Bind::define
                ? upperCase(name)
                : (isSampler(supply->type) ? "uniform highp " : "uniform ") +
                      spell(glslName(supply->type), name, supply->count) + ";");
}

int generatedCount(const Description& description, const GeneratedDesc& generated)
{
    const ParamDesc* param = findNamed(description.params, generated.count_param.name);
    return param ? static_cast<int>(param->value[0]) : generated.count;
}

void bindUniform(State& state, Pass& pass, const GlslUniform& uniform)
{
    const bool texture = isSampler(uniform.type);
    const InputDesc* input = texture ? findNamed(pass.desc->inputs, uniform.name) : nullptr;
    const std::string& name = input && !input->from.empty() ? input->from.name : uniform.name;
    const std::optional<Supply> supply = supplyOf(state.description, *pass.desc, name);
    if (!supply) return reportUnbound(state, pass, uniform, name);
    const bool fits = texture ? isSampler(supply->type) : supply->type == uniform.type;
    if (!fits || supply->count != (uniform.array ? uniform.count : 0))
        return reportShape(state, pass, uniform, *supply);
    if (findNamed(pass.reads, uniform.name) || findNamed(pass.uniforms, uniform.name))
        return;  // declared in both stages
    if (!texture)
        return pass.uniforms.push_back(
            {uniform.name, uniform.type, uniform.count, supply->source, supply->index});
    const Source source{supply->kind, supply->index};
    checkMultisampled(state, pass, uniform, source);
    pass.reads.push_back({uniform.name, input, source});
}

void checkLimits(State& state, const Pass& pass, const Shader& shader)
{
    const DeviceCaps& caps = state.caps;
    checkVectors(state, pass, shader.vertex, "vertex", caps.max_vertex_uniform_vectors);
    checkVectors(state, pass, shader.fragment, "fragment", caps.max_fragment_uniform_vectors);
    if (static_cast<int>(pass.reads.size()) <= caps.max_texture_units) return;
    report(state, Code::too_many,
           quoted(pass) + " samples " + std::to_string(pass.reads.size()) +
               " textures, and the device takes " + std::to_string(caps.max_texture_units),
           *pass.desc, "pack targets into fewer textures, or split the pass");
}

}  // namespace crevice::compiler
