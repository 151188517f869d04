// SPDX-License-Identifier: MIT
// Uniforms: the param, kernel or frame value behind each, and how many the device holds.
#include "core/compile/steps.h"

#include "core/frame/frame_values.h"
#include "core/sampling/generators.h"

#include <algorithm>

namespace crevice::compiler {

namespace {

// What may feed a uniform, and what that has to look like.
struct Supply {
    const char* what;
    GlslType type;
    int count;  // 0: no array
    UniformSource source;
    int index;
    Place place = {};  // in the config
};

// It feeds a sampler alone.
Supply texture(const char* what, const Named& named)
{
    return {what, GlslType::sampler2d, 0, UniformSource::param, -1, named.place};
}

std::optional<Supply> supplyOf(const Description& description, const PassDesc& pass,
                               std::string_view name)
{
    if (const int i = indexOf(description.params, name); i >= 0) {
        const ParamDesc& param = description.params[i];
        return Supply{"param", glslTypeOf(param.type), 0, UniformSource::param, i, param.place};
    }
    if (const int i = indexOf(description.generated, name); i >= 0) {
        const GeneratedDesc& kernel = description.generated[i];
        if (generatesTexture(kernel.generator)) return texture("generated texture", kernel);
        const int count = generatedCount(description, kernel);
        return Supply{"kernel", GlslType::vec3, count, UniformSource::kernel, i, kernel.place};
    }
    if (const TargetDesc* target = findNamed(description.targets, name))
        return texture("target", *target);
    const ImportDesc* import = findNamed(description.imports, name);
    if (import && import->type == ImportType::texture) return texture("texture import", *import);
    const FrameValueInfo* value = findNamed(kFrameValues, name);
    const bool of_draw = value && value->import == ImportType::draw_list;
    if (!value || (of_draw && pass.type != PassType::draw)) return std::nullopt;
    return Supply{"value of the frame", value->type, value->count > 1 ? value->count : 0,
                  of_draw ? UniformSource::draw : UniformSource::frame,
                  static_cast<int>(value - kFrameValues)};
}

std::string spell(GlslType type, std::string_view name, int count)
{
    std::string text = std::string(glslName(type)) + " " + std::string(name);
    return count > 0 ? text + "[" + std::to_string(count) + "]" : text;
}

std::vector<std::string> valueNames(const Description& description, const PassDesc& pass)
{
    std::vector<std::string> names = namesOf(description.params);
    for (const GeneratedDesc& each : description.generated)
        if (!generatesTexture(each.generator)) names.push_back(each.name);
    for (const FrameValueInfo& value : kFrameValues)
        if (value.import != ImportType::draw_list || pass.type == PassType::draw)
            names.push_back(value.name);
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

template <class Test>
bool anyUniform(const Pass& pass, Test&& test)
{
    return std::any_of(pass.uniforms.begin(), pass.uniforms.end(), test);
}

void reportUnsupplied(State& state, const Pass& pass, const GlslUniform& uniform)
{
    const bool draws_only = findNamed(kFrameValues, uniform.name) != nullptr;
    reportUnbound(state,
                  quoted(pass) + ": uniform '" + uniform.name + "' " +
                      (draws_only ? "has a value in draw passes only" : "is supplied by nothing"),
                  pass, uniform, uniform.name,
                  draws_only ? "make the pass a draw, or drop the uniform"
                             : suggestName(uniform.name, valueNames(state.description, *pass.desc),
                                           "values"));
}

void reportShape(State& state, const Pass& pass, const GlslUniform& uniform, const Supply& supply)
{
    const std::string wanted = spell(supply.type, uniform.name, supply.count);
    Diagnostic& error =
        reportGlsl(state, Code::uniform_type,
                   quoted(pass) + ": uniform '" + uniform.name + "' is declared as " +
                       spell(uniform.type, uniform.name, uniform.array ? uniform.count : 0) +
                       ", and the " + supply.what + " is " + wanted,
                   pass, uniform.place, "declare: uniform " + wanted + ";");
    if (supply.place.source) error.notes.push_back({supply.place, "the config declares it here"});
}

bool reads(const State& state, const Pass& pass, InputKind kind, int index)
{
    return std::any_of(pass.reads.begin(), pass.reads.end(), [&](const Read& read) {
        const std::optional<Source> source = resolve(state, read.named);
        return source && source->kind == kind && source->index == index;
    });
}

}  // namespace

int generatedCount(const Description& description, const GeneratedDesc& generated)
{
    const ParamDesc* param = findNamed(description.params, generated.count_param.name);
    return param ? static_cast<int>(param->value[0]) : generated.count;
}

bool uses(const State& state, const Pass& pass, const GeneratedDesc& generated)
{
    const int index = indexOf(state.description.generated, generated.name);
    return reads(state, pass, InputKind::generated, index) ||
           anyUniform(pass, [index](const PlanUniform& uniform) {
               return uniform.source == UniformSource::kernel && uniform.index == index;
           });
}

bool uses(const State& state, const Pass& pass, const ImportDesc& import)
{
    const int index = indexOf(state.description.imports, import.name);
    if (import.type == ImportType::texture) return reads(state, pass, InputKind::imported, index);
    if (import.type == ImportType::draw_list && pass.desc->type == PassType::draw) return true;
    return anyUniform(pass, [&import](const PlanUniform& uniform) {
        const bool of_frame =
            uniform.source == UniformSource::frame || uniform.source == UniformSource::draw;
        return of_frame && kFrameValues[uniform.index].import == import.type;
    });
}

void bindUniform(State& state, Pass& pass, const GlslUniform& uniform)
{
    const std::optional<Supply> supply = supplyOf(state.description, *pass.desc, uniform.name);
    if (!supply) return reportUnsupplied(state, pass, uniform);
    const int count = uniform.array ? uniform.count : 0;
    if (supply->type != uniform.type || supply->count != count)
        return reportShape(state, pass, uniform, *supply);
    if (!findNamed(pass.uniforms, uniform.name))  // else declared in both stages
        pass.uniforms.push_back(
            {uniform.name, uniform.type, uniform.count, supply->source, supply->index});
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
