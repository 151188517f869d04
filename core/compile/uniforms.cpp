// SPDX-License-Identifier: MIT
// Uniforms: the param, kernel or frame value behind each, and how many the device holds.
#include "core/compile/steps.h"

#include "core/frame/frame_values.h"
#include "core/sampling/generators.h"

#include <algorithm>
#include <functional>

namespace crevice::compiler {

namespace {

// What a uniform has to look like.
struct Shape {
    GlslType type;
    int count;  // 0: no array
    std::string what;
    Place place = {};  // in the config
};

std::optional<Shape> shapeOf(const Description& description, const PassDesc& pass,
                             std::string_view name)
{
    if (const ParamDesc* param = findNamed(description.params, name))
        return Shape{glslTypeOf(param->type), 0, "param", param->place};
    const GeneratedDesc* generated = findNamed(description.generated, name);
    if (generated && generatesTexture(generated->generator))
        return Shape{GlslType::sampler2d, 0, "generated texture", generated->place};
    if (generated)
        return Shape{GlslType::vec3, generatedCount(description, *generated), "kernel",
                     generated->place};
    if (const TargetDesc* target = findNamed(description.targets, name))
        return Shape{GlslType::sampler2d, 0, "target", target->place};
    const ImportDesc* import = findNamed(description.imports, name);
    if (import && import->type == ImportType::texture)
        return Shape{GlslType::sampler2d, 0, "texture import", import->place};
    const FrameValueInfo* value = findFrameValue(name);
    if (!value || (value->import == ImportType::draw_list && pass.type != PassType::draw)) return std::nullopt;
    return Shape{value->type, value->count > 1 ? value->count : 0, "value of the frame"};
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
        if (value.import != ImportType::draw_list || pass.type == PassType::draw) names.push_back(value.name);
    return names;
}

void checkVectors(State& state, const PassDesc& pass, const GlslStage& stage, const char* name,
                  int limit)
{
    const int vectors = vectorsOf(stage);
    if (vectors <= limit) return;
    report(state, Code::too_many,
           "pass '" + pass.name + "': the " + name + " shader has " + std::to_string(vectors) +
               " uniform vectors, and the device holds " + std::to_string(limit),
           pass).help = "ask for fewer samples or lights, or fewer uniforms";
}

// The value that feeds a uniform of the pass: of its own name, unless the pass renames it.
std::string_view valueName(const PassDesc& pass, std::string_view glsl)
{
    for (const auto& [name, value] : pass.uniforms)
        if (name.name == glsl) return value.name;
    return glsl;
}

bool anyUniform(const State& state, const Pass& pass,
                const std::function<bool(std::string_view value)>& test)
{
    const Shader& shader = state.shaders[pass.shader];
    for (const GlslStage* stage : {&shader.vertex, &shader.fragment})
        for (const GlslUniform& uniform : stage->uniforms)
            if (test(valueName(*pass.desc, uniform.name))) return true;
    return false;
}

bool reads(const State& state, const Pass& pass, InputKind kind, int index)
{
    return std::any_of(pass.reads.begin(), pass.reads.end(), [&](const Read& read) {
        const std::optional<Source> source = resolve(state, read.named);
        return source && source->kind == kind && source->index == index;
    });
}

}  // namespace

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

int generatedCount(const Description& description, const GeneratedDesc& generated)
{
    const ParamDesc* param = findNamed(description.params, generated.count_param.name);
    return param ? static_cast<int>(param->value[0]) : generated.count;
}

bool uses(const State& state, const Pass& pass, const GeneratedDesc& generated)
{
    const int index = indexOf(state.description.generated, generated.name);
    return reads(state, pass, InputKind::generated, index) ||
           anyUniform(state, pass, [&](std::string_view name) { return name == generated.name; });
}

bool uses(const State& state, const Pass& pass, const ImportDesc& import)
{
    const int index = indexOf(state.description.imports, import.name);
    if (import.type == ImportType::texture) return reads(state, pass, InputKind::imported, index);
    if (import.type == ImportType::draw_list && pass.desc->type == PassType::draw) return true;
    return anyUniform(state, pass, [&](std::string_view name) {
        const FrameValueInfo* value = findFrameValue(name);
        return value && value->import == import.type;
    });
}

void checkUniform(State& state, const Pass& pass, const GlslUniform& uniform)
{
    const PassDesc& desc = *pass.desc;
    const std::string_view name = valueName(desc, uniform.name);
    const std::string who = "pass '" + desc.name + "': uniform '" + uniform.name + "' ";
    const std::optional<Shape> shape = shapeOf(state.description, desc, name);
    if (!shape) {
        const bool draws_only = findFrameValue(name) != nullptr;
        Diagnostic& error = reportGlsl(
            state, Code::uniform_unbound,
            who + (draws_only ? "has a value in draw passes only" : "is supplied by nothing"), pass,
            uniform.place);
        for (const Named& each : state.description.deleted)
            if (each.name == name) error.notes.push_back({each.place, "it was deleted here"});
        error.help = draws_only ? "make the pass a draw, or drop the uniform"
                                : suggestName(name, valueNames(state.description, desc), "values");
        return;
    }
    const int count = uniform.array ? uniform.count : 0;
    if (shape->type == uniform.type && shape->count == count) return;
    Diagnostic& error =
        reportGlsl(state, Code::uniform_type,
                   who + "is declared as " + spell(uniform.type, uniform.name, count) + ", and the " +
                       shape->what + " '" + std::string(name) + "' is " +
                       spell(shape->type, name, shape->count),
                   pass, uniform.place);
    if (shape->place.source) error.notes.push_back({shape->place, "the config declares it here"});
    error.help = "declare: uniform " + spell(shape->type, uniform.name, shape->count) + ";";
}

void checkLimits(State& state, const Pass& pass, const Shader& shader)
{
    const DeviceCaps& caps = state.caps;
    checkVectors(state, *pass.desc, shader.vertex, "vertex", caps.max_vertex_uniform_vectors);
    checkVectors(state, *pass.desc, shader.fragment, "fragment", caps.max_fragment_uniform_vectors);
    if (static_cast<int>(pass.reads.size()) <= caps.max_texture_units) return;
    report(state, Code::too_many,
           "pass '" + pass.desc->name + "' samples " + std::to_string(pass.reads.size()) +
               " textures, and the device takes " + std::to_string(caps.max_texture_units),
           *pass.desc).help = "pack targets into fewer textures, or split the pass";
}

}  // namespace crevice::compiler
