// SPDX-License-Identifier: MIT
// Two plans as lists of facts, and what differs between the lists.
#include "tools/show/plan/diff.h"

#include "tools/show/plan/costs.h"
#include "tools/show/plan/names.h"
#include "tools/show/plan/print.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/config/field_types.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

// A pass, say, and what there is to say of it.
struct Part {
    std::string section;
    std::string name;
    Facts facts;
};

std::string yesNo(bool value) { return value ? "yes" : "no"; }

void addStage(Facts& facts, const char* stage, const GlslStage& glsl)
{
    for (std::size_t i = 0; i < glsl.files.size(); ++i)
        facts.push_back({i == 0 ? stage : std::string(stage) + " includes " + glsl.files[i]->name,
                         i == 0 ? glsl.files[i]->name : "yes"});
}

// What the assembled text says of a define: "64" for "#define SAMPLES 64".
std::string defineValue(const GlslStage& glsl, const std::string& name)
{
    const std::string line = "#define " + name + " ";
    const std::size_t begin = glsl.text.find(line);
    if (begin == std::string::npos) return {};
    const std::size_t end = glsl.text.find('\n', begin);
    return glsl.text.substr(begin + line.size(), end - begin - line.size());
}

void addDefines(Facts& facts, const PlanProgram& program)
{
    std::map<std::string, std::string> defines;
    for (const GlslStage* stage : {&program.vertex, &program.fragment})
        for (const std::string& name : stage->defines_used)
            defines[name] = defineValue(*stage, name);
    for (const auto& [name, value] : defines) facts.push_back({"define " + name, value});
}

std::string inputText(const Plan& plan, const PlanInput& input)
{
    const std::string source = std::string(nameOf(input.kind)) + " " + sourceName(plan, input);
    if (input.kind == InputKind::constant || input.kind == InputKind::material) return source;
    return source + " (" + table::word(input.sampling.filter) + ", " +
           table::word(input.sampling.wrap) + ")";
}

std::string attachmentText(const PlanAttachment& attachment)
{
    if (attachment.target < 0) return "no texture";
    std::string text = nameOf(attachment.load);
    if (attachment.load == LoadOp::clear)
        for (const float value : attachment.clear) text += " " + shortest(value);
    return text + ", " + nameOf(attachment.store);
}

Part partOf(const Plan& plan, const PlanPass& pass)
{
    const PlanProgram& program = plan.programs[pass.program];
    Facts facts = {{"type", table::word(pass.type)},
                   {"size", sizeText(pass.extent)},
                   {"samples", std::to_string(pass.samples)}};
    addStage(facts, "vertex", program.vertex);
    addStage(facts, "fragment", program.fragment);
    addDefines(facts, program);
    for (const PlanInput& input : pass.inputs) {
        if (input.sampler.empty())
            facts.push_back({"drawn where", sourceName(plan, input) + " > 0"});
        else
            facts.push_back({"input " + input.sampler, inputText(plan, input)});
    }
    if (pass.type == PassType::fullscreen)
        facts.push_back({"drawn within", boundsText(plan, pass)});
    for (const PlanAttachment& color : pass.color)
        facts.push_back({"writes " + color.name, attachmentText(color)});
    if (pass.has_depth && !isMasked(pass))
        facts.push_back({"writes " + pass.depth.name, attachmentText(pass.depth)});
    const MovedBytes bytes = movedBytes(plan, pass);
    facts.insert(facts.end(), {{"depth_test", table::word(pass.state.depth_test)},
                               {"depth_write", yesNo(pass.state.depth_write)},
                               {"cull", table::word(pass.state.cull)},
                               {"read", bytesText(bytes.read)},
                               {"written", bytesText(bytes.written)}});
    return {"passes", pass.name, std::move(facts)};
}

Part partOf(const Plan& plan, const PlanTarget& target)
{
    const PlanTexture& texture = plan.textures[target.texture];
    const PlanTexture& drawn = plan.textures[target.drawn_texture];
    return {"targets",
            target.name,
            {{"format", formatInfo(texture.format).name},
             {"size", sizeText(texture.extent)},
             {"samples", std::to_string(drawn.samples)},
             {"history", yesNo(target.history_texture >= 0)}}};
}

Part partOf(const Plan& plan, const PlanOutput& output)
{
    const std::string from = output.constant >= 0
                                 ? "constant " + shortest(plan.constants[output.constant].value)
                                 : "target " + plan.targets[output.target].name;
    return {"outputs", output.name, {{"from", from}}};
}

std::vector<Part> partsOf(const Plan& plan)
{
    std::vector<Part> parts;
    for (const PlanPass& each : plan.passes) parts.push_back(partOf(plan, each));
    for (const PlanTarget& each : plan.targets) parts.push_back(partOf(plan, each));
    for (const PlanOutput& each : plan.outputs) parts.push_back(partOf(plan, each));
    for (const Elided& each : allElided(plan))
        parts.push_back({"left out", each.what, {{each.optimization, each.reason}}});
    return parts;
}

std::string factOf(const Facts& facts, const std::string& name)
{
    for (const auto& [key, value] : facts)
        if (key == name) return value;
    return {};
}

std::vector<PlanChange::Property> differences(const Facts& before, const Facts& after)
{
    std::vector<PlanChange::Property> properties;
    for (const auto& [name, value] : before)
        if (const std::string other = factOf(after, name); other != value)
            properties.push_back({name, value, other});
    for (const auto& [name, value] : after)
        if (factOf(before, name).empty()) properties.push_back({name, "", value});
    return properties;
}

const Part* findPart(const std::vector<Part>& parts, const Part& like)
{
    for (const Part& part : parts)
        if (part.section == like.section && part.name == like.name) return &part;
    return nullptr;
}

std::vector<PlanChange> changesBetween(const std::vector<Part>& before,
                                       const std::vector<Part>& after)
{
    using Kind = PlanChange::Kind;
    std::vector<PlanChange> changes;
    for (const Part& part : before) {
        const Part* other = findPart(after, part);
        const Kind kind = other ? Kind::changed : Kind::only_before;
        auto properties = differences(part.facts, other ? other->facts : Facts{});
        if (!properties.empty()) changes.push_back({part.section, part.name, kind, properties});
    }
    for (const Part& part : after)
        if (!findPart(before, part))
            changes.push_back(
                {part.section, part.name, Kind::only_after, differences({}, part.facts)});
    const std::vector<std::string> sections = {"passes", "targets", "outputs", "left out"};
    const auto rank = [&](const PlanChange& change) {
        return std::find(sections.begin(), sections.end(), change.section);
    };
    std::stable_sort(changes.begin(), changes.end(),
                     [&](const PlanChange& a, const PlanChange& b) { return rank(a) < rank(b); });
    return changes;
}

bool isBytes(const PlanTotal& total) { return total.name.find("bytes") != std::string::npos; }

std::string amount(const PlanTotal& total, double value)
{
    return isBytes(total) ? bytesText(value) : std::to_string(std::llround(value));
}

// "define SAMPLES" is of the kind "define" and called "SAMPLES"; "size" has no kind.
std::pair<std::string, std::string> kindAndName(const std::string& property)
{
    const std::size_t space = property.rfind(' ');
    if (space == std::string::npos) return {"", property};
    return {property.substr(0, space), property.substr(space + 1)};
}

// What is on one side only, a line for each kind: "- define: SAMPLES = 64, POWER_OF = 0".
std::string oneSidedText(const PlanChange& change, bool before)
{
    std::map<std::string, std::string> lines;
    for (const PlanChange::Property& each : change.properties) {
        const std::string& value = before ? each.before : each.after;
        if (!(before ? each.after : each.before).empty()) continue;
        const auto [kind, name] = kindAndName(each.name);
        std::string& line = lines[kind];
        const char* const is = kind.empty() ? " " : " = ";
        line += (line.empty() ? "" : ", ") + name + (value == "yes" ? "" : is + value);
    }
    std::string text;
    for (const auto& [kind, line] : lines)
        text += std::string("      ") + (before ? "- " : "+ ") + (kind.empty() ? "" : kind + ": ") +
                line + "\n";
    return text;
}

std::string changeText(const PlanChange& change)
{
    const char* const signs[] = {"  - ", "  + ", "  ~ "};
    std::string text = signs[static_cast<int>(change.kind)] + change.name + "\n";
    for (const PlanChange::Property& each : change.properties)
        if (!each.before.empty() && !each.after.empty())
            text += "      " + each.name + ": " + each.before + " -> " + each.after + "\n";
    return text + oneSidedText(change, true) + oneSidedText(change, false);
}

}  // namespace

PlanDiff diffPlans(const Plan& before, const Plan& after)
{
    PlanDiff diff{printableLine(before.config) + " " + sizeText(before.extent),
                  printableLine(after.config) + " " + sizeText(after.extent)};
    diff.changes = changesBetween(partsOf(before), partsOf(after));
    const auto total = [&](const char* name, double from, double to) {
        diff.totals.push_back({name, from, to});
    };
    total("passes", static_cast<double>(before.passes.size()),
          static_cast<double>(after.passes.size()));
    total("textures", textureCount(before), textureCount(after));
    total("texture_bytes", before.texture_bytes, after.texture_bytes);
    const MovedBytes from = movedBytes(before), to = movedBytes(after);
    total("bytes_read", from.read, to.read);
    total("bytes_written", from.written, to.written);
    return diff;
}

std::string toText(const PlanDiff& diff)
{
    std::string text = "from " + diff.before + " to " + diff.after + "\n";
    std::string section;
    for (const PlanChange& change : diff.changes) {
        if (change.section != section) text += change.section + "\n";
        section = change.section;
        text += changeText(change);
    }
    text += "totals\n";
    for (const PlanTotal& total : diff.totals) {
        const double more = total.after - total.before;
        std::string name = total.name;
        std::replace(name.begin(), name.end(), '_', ' ');
        text +=
            "  " + name + ": " + amount(total, total.before) + " -> " + amount(total, total.after);
        text +=
            more == 0 ? "\n" : (more > 0 ? " (+" : " (-") + amount(total, std::abs(more)) + ")\n";
    }
    return text;
}

std::string toJson(const PlanDiff& diff)
{
    using Json = nlohmann::ordered_json;
    const char* const kinds[] = {"only_before", "only_after", "changed"};
    const auto side = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
    Json json = {{"before", diff.before},
                 {"after", diff.after},
                 {"changes", Json::array()},
                 {"totals", Json::object()}};
    for (const PlanChange& change : diff.changes) {
        Json properties = Json::array();
        for (const PlanChange::Property& each : change.properties)
            properties.push_back(
                {{"name", each.name}, {"before", side(each.before)}, {"after", side(each.after)}});
        json["changes"].push_back({{"section", change.section},
                                   {"name", change.name},
                                   {"kind", kinds[static_cast<int>(change.kind)]},
                                   {"properties", std::move(properties)}});
    }
    for (const PlanTotal& total : diff.totals)
        json["totals"][total.name] = {std::llround(total.before), std::llround(total.after)};
    return jsonLines(json) + "\n";
}

}  // namespace crevice
