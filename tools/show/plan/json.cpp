// SPDX-License-Identifier: MIT
// Plans as JSON for programs: the same facts as the text, and the keys of the programs.
#include "tools/show/plan/print.h"

#include "core/base/text.h"
#include "core/config/field_types.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace crevice {
namespace {

using Json = nlohmann::ordered_json;

Json sizeJson(const Extent& extent) { return {extent.width, extent.height}; }

/// As short as a float is written: 0.1 and not 0.10000000149.
Json numberJson(float number)
{
    if (number == std::floor(number) && std::abs(number) < 1e6f) return static_cast<int>(number);
    return parseNumber(shortest(number)).value_or(number);
}

/// An index, or null for none.
Json indexJson(int index) { return index < 0 ? Json() : Json(index); }

template <class List, class Make>
Json listOf(const List& elements, const Make& make)
{
    Json list = Json::array();
    for (const auto& element : elements) list.push_back(make(element));
    return list;
}

Json attachmentJson(const Plan& plan, const PlanAttachment& attachment)
{
    const bool textured = attachment.target >= 0;
    return {{"target", attachment.name},
            {"texture", indexJson(textured ? plan.targets[attachment.target].texture : -1)},
            {"load", nameOf(attachment.load)},
            {"store", nameOf(attachment.store)},
            {"clear", listOf(attachment.clear, numberJson)}};
}

Json inputJson(const Plan& plan, const PlanInput& input)
{
    return {{"sampler", input.name},
            {"kind", nameOf(input.kind)},
            {"from", sourceName(plan, input)},
            {"filter", table::word(input.sampling.filter)},
            {"wrap", table::word(input.sampling.wrap)}};
}

Json passJson(const Plan& plan, const PlanPass& pass)
{
    const MovedBytes bytes = movedBytes(plan, pass);
    const auto attachment = [&](const PlanAttachment& each) { return attachmentJson(plan, each); };
    const auto input = [&](const PlanInput& each) { return inputJson(plan, each); };
    const auto uniform = [](const PlanUniform& each) -> Json {
        return {{"name", each.name}, {"source", nameOf(each.source)}};
    };
    const int culled = pass.cull_below_pixel;
    return {{"name", pass.name},
            {"type", table::word(pass.type)},
            {"program", pass.program},
            {"extent", sizeJson(pass.extent)},
            {"bytes_read", std::llround(bytes.read)},
            {"bytes_written", std::llround(bytes.written)},
            {"blended", pass.blended},
            {"masked", isMasked(pass)},
            {"box", pass.box < 0 ? Json() : Json(plan.boxes[pass.box].name)},
            {"layers", pass.layers},
            {"layers_at_once", pass.layers_at_once},
            {"frames", pass.frames},
            {"scissor", pass.scissor},
            {"cull_below_pixel", culled < 0 ? Json() : Json(plan.params[culled].name)},
            {"state",
             {{"depth_test", table::word(pass.state.depth_test)},
              {"depth_write", pass.state.depth_write},
              {"cull", table::word(pass.state.cull)},
              {"blend", table::word(pass.state.blend)}}},
            {"inputs", listOf(pass.inputs, input)},
            {"uniforms", listOf(pass.uniforms, uniform)},
            {"color", listOf(pass.color, attachment)},
            {"depth", pass.has_depth ? attachment(pass.depth) : Json()}};
}

Json targetJson(const PlanTarget& target)
{
    return {{"name", target.name},
            {"texture", target.texture},
            {"drawn_texture", target.drawn_texture},
            {"first_pass", target.first_pass},
            {"last_pass", target.last_pass},
            {"history_texture", indexJson(target.history_texture)}};
}

Json textureJson(const PlanTexture& texture)
{
    return {{"format", formatInfo(texture.format).name},
            {"extent", sizeJson(texture.extent)},
            {"samples", texture.samples},
            {"depth", texture.depth},
            {"mips", texture.mips},
            {"bytes", std::llround(textureBytes(texture))},
            {"copies", texture.copies},
            {"targets", texture.targets}};
}

Json outputJson(const Plan& plan, const PlanOutput& output)
{
    const bool constant = output.constant >= 0;
    return {{"name", output.name},
            {"target", constant ? Json() : Json(plan.targets[output.target].name)},
            {"constant", constant ? numberJson(plan.constants[output.constant]) : Json()}};
}

bool isFlat(const Json& json)
{
    for (const Json& each : json)
        if (each.is_object() || (each.is_array() && !isFlat(each))) return false;
    return true;
}

}  // namespace

std::string jsonLines(const nlohmann::ordered_json& json, const std::string& indent)
{
    if (!json.is_structured()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool flat = isFlat(json);
    const std::string inner = indent + "  ";
    std::string text;
    for (const auto& [key, value] : json.items()) {
        if (!text.empty()) text += flat ? ", " : ",";
        if (!flat) text += "\n" + inner;
        if (json.is_object()) text += jsonString(key) + ": ";
        text += jsonLines(value, inner);
    }
    if (!flat) text += "\n" + indent;
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

std::string toJson(const Plan& plan)
{
    const auto pass = [&](const PlanPass& each) { return passJson(plan, each); };
    const auto output = [&](const PlanOutput& each) { return outputJson(plan, each); };
    const auto program = [](const PlanProgram& each) -> Json {
        return {{"label", each.label}, {"key", each.key}};
    };
    const auto generated = [](const GeneratorDesc& each) -> Json {
        return {{"name", each.name}, {"generator", each.generator}, {"count", each.count}};
    };
    const auto import = [](const ImportDesc& each) -> Json {
        return {{"name", each.name}, {"type", table::word(each.type)}, {"optional", each.optional}};
    };
    const auto elided = [](const Elided& each) -> Json {
        return {{"what", each.what}, {"optimization", each.optimization}, {"reason", each.reason}};
    };
    const Json json = {{"config", plan.config},
                       {"extent", sizeJson(plan.extent)},
                       {"views", plan.views},
                       {"texture_bytes", std::llround(plan.texture_bytes)},
                       {"passes", listOf(plan.passes, pass)},
                       {"targets", listOf(plan.targets, targetJson)},
                       {"textures", listOf(plan.textures, textureJson)},
                       {"programs", listOf(plan.programs, program)},
                       {"generated", listOf(plan.generated, generated)},
                       {"imports", listOf(plan.imports, import)},
                       {"outputs", listOf(plan.outputs, output)},
                       {"elided", listOf(allElided(plan), elided)}};
    return jsonLines(json) + "\n";
}

}  // namespace crevice
