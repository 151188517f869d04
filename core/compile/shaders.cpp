// SPDX-License-Identifier: MIT
// Shaders: their defines, stages and outputs; uniforms, and what is behind each; renames of
// nothing.
#include "core/compile/steps.h"

#include "core/config/values.h"
#include "core/frame/frame_math.h"
#include "core/sampling/generators.h"

namespace crevice::compiler {
namespace {

void addFeature(GlslDefines& defines, const FeatureDesc& feature)
{
    const std::string name = upperCase(feature.name);
    defines[name] = std::to_string(feature.value);
    if (feature.boolean) return;
    for (std::size_t i = 0; i < feature.values.size(); ++i)
        defines[name + "_" + upperCase(feature.values[i])] = std::to_string(i);
}

// What every shader may mention.
GlslDefines commonDefines(const State& state)
{
    GlslDefines defines;
    for (std::size_t i = 0; i < state.targets.size(); ++i)
        defines[stepDefine(state.description.targets[i].name)] = stepsOf(state.targets[i].format);
    for (const ImportDesc& import : state.description.imports)
        if (import.type == ImportType::texture)
            defines[stepDefine(import.name)] = stepsOf(formatFromName(import.format));
    for (const ParamDesc& param : state.description.params)
        if (param.bind == Bind::define) defines[upperCase(param.name)] = literal(param);
    for (const FeatureDesc& feature : state.description.features) addFeature(defines, feature);
    defines["MAX_LIGHTS"] = std::to_string(kMaxLights);
    for (const TraitInfo& trait : kTraits)
        defines[trait.define] = std::to_string(trait.value(state.traits));
    return defines;
}

// Assembles a shader once, however many passes use it, so that its errors come once.
const Shader& assembled(State& state, int index)
{
    Shader& shader = state.shaders[index];
    if (shader.assembled) return shader;
    shader.assembled = true;
    const ShaderDesc& desc = state.description.shaders[index];
    GlslDefines own;
    if (!desc.defines.empty()) own = state.defines;
    for (const auto& [name, value] : desc.defines) own[name] = value;
    const GlslDefines& defines = desc.defines.empty() ? state.defines : own;
    std::map<std::string, std::string> interfaces;
    for (const InterfaceDesc& each : state.description.interfaces)
        interfaces[each.name] = each.file.name;
    auto stage = [&](const Reference& path, GlslStage& into) {
        Result<GlslStage> result =
            assembleStage(state.description.files, interfaces, path.name, defines);
        if (result) into = std::move(*result);
        for (Diagnostic each : result.diagnostics()) {
            each.pointer = path.pointer;
            each.notes.push_back({path.place, "shader '" + desc.name + "' names the file here"});
            state.diagnostics.push_back(std::move(each));
        }
        return result.ok();
    };
    const bool vertex_ok = stage(desc.vertex, shader.vertex);
    shader.ok = stage(desc.fragment, shader.fragment) && vertex_ok;
    return shader;
}

bool writes(const GlslStage& fragment, int location)
{
    return anyOf(fragment.outputs,
                 [&](const GlslOutput& output) { return output.location == location; });
}

// Takes the last targets off the pass whose outputs an #if takes out of the shader.
void dropUnwritten(Pass& pass, const GlslStage& fragment)
{
    while (!pass.color.empty() && !writes(fragment, static_cast<int>(pass.color.size()) - 1)) {
        GlslStage copy = fragment;
        const bool named = dropOutput(copy, pass.desc->color[pass.color.size() - 1].name);
        if (!named || copy.outputs.size() < fragment.outputs.size()) return;
        pass.color.pop_back();
    }
}

void checkOutputs(State& state, const Pass& reader, const GlslStage& fragment)
{
    const PassDesc& pass = *reader.desc;
    const int count = static_cast<int>(reader.color.size());
    const std::string who = quoted(reader) + ": ";
    for (const GlslOutput& output : fragment.outputs) {
        if (isFull(state)) return;
        if (output.location >= 0 && output.location < count) {
            const int target = reader.color[output.location];
            const FormatInfo& format = formatInfo(state.targets[target].format);
            const std::string wanted = glslName(static_cast<GlslType>(format.channels - 1));
            if (output.type > GlslType::vec4)
                reportGlsl(state, Code::output_mismatch,
                           who + "'" + output.name + "' is not of floats, which target '" +
                               nameOf(state, target) + "' of format " + format.name + " holds",
                           reader, output.place,
                           "declare: out " + wanted + " " + output.name + ";");
            continue;
        }
        state.unwritten.insert(output.name);
        Diagnostic& error = reportGlsl(
            state, Code::output_mismatch,
            who + "the shader writes '" + output.name + "' at location " +
                std::to_string(output.location) + ", and the pass has " + std::to_string(count) +
                " colour target" + (count == 1 ? "" : "s"),
            reader, output.place, "add a target to `color`, or take the output out of the shader");
        if (count == 0) continue;
        blame(error, pass.color.back().place, "the GLSL declares it here");
        error.pointer = pass.color.back().pointer;
    }
    for (int i = 0; i < count; ++i) {
        if (writes(fragment, i) || isFull(state)) continue;
        report(state, Code::output_mismatch,
               who + "its shader has no output at location " + std::to_string(i) + " for target '" +
                   pass.color[i].name + "'",
               pass.color[i], "add: layout(location = " + std::to_string(i) + ") out ...");
    }
}

// Nobody fills a block but a host that draws by itself.
void refuseBlocks(State& state, const ShaderDesc& shader, const Reference& path,
                  const GlslStage& stage)
{
    for (const GlslUniform& block : stage.blocks)
        state.diagnostics.push_back(
            {Code::preprocessor,
             "'" + block.name + "' is a uniform block, which no config can fill",
             "declare its members one by one: uniform float radius;",
             block.place,
             path.pointer,
             {{path.place, "shader '" + shader.name + "' names the file here"}}});
}

// Whether any GLSL has the word, also where an #if hides it.
bool isMentioned(const State& state, std::string_view word)
{
    const auto& files = state.description.files;
    return anyOf(files, [&](const auto& file) {
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
    if (contains(names, from.name) && !has(help, "did you mean"))
        help = "did you mean '" + from.name + "'? " + help;
    report(state, Code::input_unused,
           quoted(pass) + " " + what + " '" + name.name + "', which shader '" + shader.name +
               "' does not have",
           name, help);
}

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
        if (each.name == name && isVolume(each))
            return Supply{"volume", GlslType::sampler3d, 0, index, each.place};
        if (each.name == name) return texture("target", InputKind::target, index, each.place);
        if (each.history && historyName(each) == name)
            return texture("history", InputKind::history, index, each.place);
    }
    if (const int i = indexOf(description.imports, name); i >= 0)
        if (const ImportDesc& each = description.imports[i]; each.type == ImportType::texture)
            return texture("texture import", InputKind::imported, i, each.place);
    if (const int i = indexOf(description.boxes, name); i >= 0)
        return Supply{"box", GlslType::mat4, 0, i, description.boxes[i].place, UniformSource::box};
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
        vectors += uniform.count * (type == GlslType::mat4 ? 4 : type == GlslType::mat3 ? 3 : 1);
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

// Finds what feeds the uniform, and adds that to the pass.
void bindUniform(State& state, Pass& pass, const GlslUniform& uniform)
{
    const bool texture = isSampler(uniform.type);
    const InputDesc* input = texture ? findNamed(pass.desc->inputs, uniform.name) : nullptr;
    const std::string& name = input && !input->from.empty() ? input->from.name : uniform.name;
    const std::optional<Supply> supply = supplyOf(state.description, *pass.desc, name);
    if (!supply) return reportUnbound(state, pass, uniform, name);
    const bool volume = GlslType::sampler3d == uniform.type;
    const bool fits =
        texture ? isSampler(supply->type) && (supply->type == GlslType::sampler3d) == volume
                : supply->type == uniform.type;
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

void readPass(State& state, Pass& pass)
{
    const Shader& shader = assembled(state, pass.shader);
    if (!shader.ok) return;
    if (pass.desc->type != PassType::draw) {
        const ShaderDesc& desc = state.description.shaders[pass.shader];
        refuseBlocks(state, desc, desc.vertex, shader.vertex);
        refuseBlocks(state, desc, desc.fragment, shader.fragment);
    }
    for (const GlslStage* stage : {&shader.vertex, &shader.fragment})
        for (const GlslUniform& uniform : stage->uniforms)
            if (!isFull(state)) bindUniform(state, pass, uniform);
    for (const InputDesc& input : pass.desc->inputs)
        checkMentioned(state, pass, input, input.from, "renames input");
    for (const PreservesConstantDesc& each : pass.desc->preserves_constant)
        checkMentioned(state, pass, each.sampler, each.sampler,
                       "preserves the constant of sampler");
    dropUnwritten(pass, shader.fragment);
    checkOutputs(state, pass, shader.fragment);
    checkLimits(state, pass, shader);
}

// The mask of a pass is one more target that it reads, where some pass draws it and it fits.
void readMask(State& state, Pass& pass)
{
    const int mask = indexOf(state.description.targets, pass.desc->mask.name);
    if (mask < 0 || (pass.over < 0 && !state.applies("depth_mask"))) return;
    const std::vector<int> own = writtenBy(pass);
    const bool fits = !own.empty() && state.sizes.of(mask) == state.sizes.of(own.front()) &&
                      askedSamples(state.description, mask) == 1 &&
                      askedSamples(state.description, own.front()) == 1;
    const auto draws_it = [&](const Pass& each) { return each.active && each.depth == mask; };
    if (fits && anyOf(state.passes, draws_it))
        pass.reads.push_back({"", nullptr, {InputKind::target, mask}});
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

void readShaders(State& state)
{
    state.defines = commonDefines(state);
    for (Pass& pass : state.passes)
        if (pass.active && pass.shader >= 0 && !isFull(state)) readPass(state, pass);
    for (Pass& pass : state.passes)
        if (pass.active) readMask(state, pass);
}

}  // namespace crevice::compiler
