// SPDX-License-Identifier: MIT
// Shaders: their defines, their stages and their outputs, and renames of what none of them has.
#include "core/compile/steps.h"

#include "core/frame/frame_math.h"

namespace crevice::compiler {
namespace {

// A number as GLSL reads it; vectors are never defines.
std::string literal(const ParamDesc& param)
{
    if (param.type == ParamType::int_) return std::to_string(static_cast<int>(param.value[0]));
    std::string text = shortest(param.value[0]);
    if (text.find_first_of(".e") == text.npos) text += ".0";
    return text;
}

void addFeature(GlslDefines& defines, const FeatureDesc& feature)
{
    const std::string name = upperCase(feature.name);
    defines[name] = std::to_string(feature.value);
    if (feature.boolean) return;
    for (std::size_t i = 0; i < feature.values.size(); ++i)
        defines[name + "_" + upperCase(feature.values[i])] = std::to_string(i);
}

// The resolution of a format, as GLSL.
std::string stepsOf(Format format)
{
    const FormatInfo& info = formatInfo(format);
    return "vec2(" + scientific(info.absolute_step, 3) + ", " + scientific(info.relative_step, 3) +
           ")";
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
    if (contains(names, from.name) && help.find("did you mean") == std::string::npos)
        help = "did you mean '" + from.name + "'? " + help;
    report(state, Code::input_unused,
           quoted(pass) + " " + what + " '" + name.name + "', which shader '" + shader.name +
               "' does not have",
           name, help);
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
    if (mask < 0 || !state.applies("depth_mask")) return;
    const std::vector<int> own = writtenBy(pass);
    const bool fits = !own.empty() && sizeOf(state, mask) == sizeOf(state, own.front()) &&
                      askedSamples(state, mask) == 1 && askedSamples(state, own.front()) == 1;
    const auto draws_it = [&](const Pass& each) { return each.active && each.depth == mask; };
    if (fits && anyOf(state.passes, draws_it))
        pass.reads.push_back({"", nullptr, {InputKind::target, mask}});
}

}  // namespace

std::string stepDefine(const std::string& texture) { return upperCase(texture) + "_STEP"; }

void readShaders(State& state)
{
    state.defines = commonDefines(state);
    for (Pass& pass : state.passes)
        if (pass.active && pass.shader >= 0 && !isFull(state)) readPass(state, pass);
    for (Pass& pass : state.passes)
        if (pass.active) readMask(state, pass);
}

}  // namespace crevice::compiler
