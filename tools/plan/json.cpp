// SPDX-License-Identifier: MIT
// Plans as JSON for programs: the same facts as the text, and the keys of the programs.
#include "tools/plan/costs.h"
#include "tools/plan/names.h"
#include "tools/plan/print.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/config/field_types.h"

#include <cmath>

namespace crevice {

namespace {

std::string json(const std::string& text) { return jsonString(text); }
std::string json(const char* text) { return jsonString(text); }
std::string json(int number) { return std::to_string(number); }
std::string json(float number) { return shortest(number); }
std::string json(bool value) { return value ? "true" : "false"; }
std::string json(const Extent& extent)
{
    return "[" + json(extent.width) + ", " + json(extent.height) + "]";
}

std::string bytesJson(double bytes) { return std::to_string(std::llround(bytes)); }

template <class T>
std::string word(T value)
{
    return json(table::word(value));
}

// An index, or null for none.
std::string indexJson(int index) { return index < 0 ? "null" : json(index); }

// One entry for each element, on lines of their own.
template <class List, class Print>
std::string list(const List& elements, Print print, const std::string& indent = "    ")
{
    std::string text;
    for (const auto& element : elements)
        text += (text.empty() ? "\n" : ",\n") + indent + print(element);
    if (text.empty()) return "[]";
    return "[" + text + "\n" + indent.substr(2) + "]";
}

std::string attachmentJson(const Plan& plan, const PlanAttachment& attachment)
{
    const bool textured = attachment.target >= 0;
    std::string clear;
    for (const float value : attachment.clear) clear += (clear.empty() ? "" : ", ") + json(value);
    return "{\"target\": " + json(attachment.name) +
           ", \"texture\": " + indexJson(textured ? plan.targets[attachment.target].texture : -1) +
           ", \"load\": " + json(nameOf(attachment.load)) +
           ", \"store\": " + json(nameOf(attachment.store)) + ", \"clear\": [" + clear + "]}";
}

std::string inputJson(const Plan& plan, const PlanInput& input)
{
    return "{\"sampler\": " + json(input.sampler) + ", \"kind\": " + json(nameOf(input.kind)) +
           ", \"from\": " + json(sourceName(plan, input)) +
           ", \"filter\": " + word(input.sampling.filter) +
           ", \"wrap\": " + word(input.sampling.wrap) + "}";
}

std::string uniformJson(const PlanUniform& uniform)
{
    return "{\"name\": " + json(uniform.name) + ", \"source\": " + json(nameOf(uniform.source)) +
           "}";
}

std::string stateJson(const StateDesc& state)
{
    return "{\"depth_test\": " + word(state.depth_test) +
           ", \"depth_write\": " + json(state.depth_write) + ", \"cull\": " + word(state.cull) +
           "}";
}

std::string passJson(const Plan& plan, const PlanPass& pass)
{
    const std::string indent = "        ";
    const MovedBytes bytes = movedBytes(plan, pass);
    const auto attachment = [&](const PlanAttachment& each) { return attachmentJson(plan, each); };
    const auto input = [&](const PlanInput& each) { return inputJson(plan, each); };
    return "{\"name\": " + json(pass.name) + ", \"type\": " + word(pass.type) +
           ", \"program\": " + json(pass.program) + ", \"extent\": " + json(pass.extent) +
           ", \"bytes_read\": " + bytesJson(bytes.read) +
           ", \"bytes_written\": " + bytesJson(bytes.written) +
           ",\n      \"masked\": " + json(isMasked(pass)) + ", \"scissor\": " + json(pass.scissor) +
           ", \"cull_below_pixel\": " +
           (pass.cull_below_pixel < 0 ? "null" : json(plan.params[pass.cull_below_pixel].name)) +
           ",\n      \"state\": " + stateJson(pass.state) +
           ",\n      \"inputs\": " + list(pass.inputs, input, indent) +
           ",\n      \"uniforms\": " + list(pass.uniforms, uniformJson, indent) +
           ",\n      \"color\": " + list(pass.color, attachment, indent) +
           ",\n      \"depth\": " + (pass.has_depth ? attachment(pass.depth) : "null") + "}";
}

std::string targetJson(const PlanTarget& target)
{
    return "{\"name\": " + json(target.name) + ", \"texture\": " + json(target.texture) +
           ", \"drawn_texture\": " + json(target.drawn_texture) +
           ", \"first_pass\": " + json(target.first_pass) +
           ", \"last_pass\": " + json(target.last_pass) +
           ", \"history_texture\": " + indexJson(target.history_texture) + "}";
}

std::string textureJson(const PlanTexture& texture)
{
    std::string targets;
    for (const std::string& name : texture.targets)
        targets += (targets.empty() ? "" : ", ") + json(name);
    return "{\"format\": " + json(formatInfo(texture.format).name) +
           ", \"extent\": " + json(texture.extent) + ", \"samples\": " + json(texture.samples) +
           ", \"bytes\": " + bytesJson(textureBytes(texture)) +
           ", \"copies\": " + json(texture.copies) + ", \"targets\": [" + targets + "]}";
}

std::string programJson(const PlanProgram& program)
{
    return "{\"label\": " + json(program.label) + ", \"key\": " + json(program.key) + "}";
}

std::string generatedJson(const GeneratorDesc& each)
{
    return "{\"name\": " + json(each.name) + ", \"generator\": " + json(each.generator) +
           ", \"count\": " + json(each.count) + "}";
}

std::string importJson(const ImportDesc& each)
{
    return "{\"name\": " + json(each.name) + ", \"type\": " + word(each.type) +
           ", \"optional\": " + json(each.optional) + "}";
}

std::string outputJson(const Plan& plan, const PlanOutput& output)
{
    const bool constant = output.constant >= 0;
    return "{\"name\": " + json(output.name) +
           ", \"target\": " + (constant ? "null" : json(plan.targets[output.target].name)) +
           ", \"constant\": " + (constant ? json(plan.constants[output.constant].value) : "null") +
           "}";
}

std::string elidedJson(const Elided& each)
{
    return "{\"what\": " + json(each.what) + ", \"optimization\": " + json(each.optimization) +
           ", \"reason\": " + json(each.reason) + "}";
}

}  // namespace

std::string toJson(const Plan& plan)
{
    const auto pass = [&](const PlanPass& each) { return passJson(plan, each); };
    const auto output = [&](const PlanOutput& each) { return outputJson(plan, each); };
    return "{\n  \"config\": " + json(plan.config) + ",\n  \"extent\": " + json(plan.extent) +
           ",\n  \"views\": " + json(plan.views) +
           ",\n  \"texture_bytes\": " + bytesJson(plan.texture_bytes) +
           ",\n  \"passes\": " + list(plan.passes, pass) +
           ",\n  \"targets\": " + list(plan.targets, targetJson) +
           ",\n  \"textures\": " + list(plan.textures, textureJson) +
           ",\n  \"programs\": " + list(plan.programs, programJson) +
           ",\n  \"generated\": " + list(plan.generated, generatedJson) +
           ",\n  \"imports\": " + list(plan.imports, importJson) +
           ",\n  \"outputs\": " + list(plan.outputs, output) +
           ",\n  \"elided\": " + list(allElided(plan), elidedJson) + "\n}\n";
}

}  // namespace crevice
