// SPDX-License-Identifier: MIT
// Diagnostics as SARIF. The numbers in brackets are sections of the specification.
#include "tools/commands/cli/sarif.h"

#include "core/base/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace crevice {
namespace {

using Json = nlohmann::ordered_json;

/// The place as a file that a reader can open; what --set gave is in none.
bool isFile(const Place& place)
{
    return place.source && !startsWith(place.source->name, "--set ");
}

/// A path as a URI reference [3.10.1].
std::string uriOf(const std::string& path)
{
    const std::string kept = "-._~/ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
    const char* const digits = "0123456789ABCDEF";
    std::string uri = startsWith(path, "/") ? "file://" : "";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        if (kept.find(c) != std::string::npos)
            uri += c;
        else
            uri += {'%', digits[byte >> 4], digits[byte & 15]};
    }
    return uri;
}

/// The column, from 1, in characters instead of bytes.
int characterColumn(const Place& place, int column)
{
    const std::string_view text =
        lineOf(place.source->text, place.line).substr(0, static_cast<std::size_t>(column - 1));
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    return column - static_cast<int>(std::count_if(text.begin(), text.end(), continues));
}

Json physicalLocation(const Place& place)
{
    Json location = {{"artifactLocation", {{"uri", uriOf(place.source->name)}}}};
    if (place.line < 1) return location;
    Json& region = location["region"] = {{"startLine", place.line}};
    if (place.column < 1) return location;
    region["startColumn"] = characterColumn(place, place.column);
    region["endColumn"] = characterColumn(place, place.column + std::max(place.length, 1));
    return location;
}

Json resultOf(const Diagnostic& diagnostic, std::size_t rule)
{
    const std::string help = diagnostic.help.empty() ? "" : "\nhelp: " + diagnostic.help;
    Json result = {{"ruleId", codeName(diagnostic.code)},
                   {"ruleIndex", rule},
                   {"level", diagnostic.severity == Severity::error ? "error" : "warning"},
                   {"message", {{"text", diagnostic.message + help}}}};
    Json location = Json::object();
    if (isFile(diagnostic.place)) location["physicalLocation"] = physicalLocation(diagnostic.place);
    if (!diagnostic.pointer.empty())
        location["logicalLocations"] = {{{"fullyQualifiedName", diagnostic.pointer}}};
    if (!location.empty()) result["locations"] = Json::array({location});
    for (const Note& note : diagnostic.notes) {
        Json related = {{"message", {{"text", note.text}}}};
        if (isFile(note.place)) related["physicalLocation"] = physicalLocation(note.place);
        result["relatedLocations"].push_back(std::move(related));
    }
    return result;
}

Json ruleOf(const CodeRule& rule)
{
    return {{"id", codeName(rule.code)},
            {"name", rule.name},
            {"shortDescription", {{"text", rule.text}}}};
}

}  // namespace

std::string toSarif(const Diagnostics& diagnostics, const std::string& version)
{
    Json rules = Json::array(), results = Json::array();
    std::vector<Code> listed;
    for (const Diagnostic& each : diagnostics) {
        const auto at = std::find(listed.begin(), listed.end(), each.code);
        results.push_back(resultOf(each, static_cast<std::size_t>(at - listed.begin())));
        if (at != listed.end()) continue;
        listed.push_back(each.code);
        for (const CodeRule& rule : codeRules())
            if (rule.code == each.code) rules.push_back(ruleOf(rule));
    }
    const Json driver = {{"name", "crevice"}, {"version", version}, {"rules", rules}};
    const Json run = {
        {"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", results}};
    const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({run})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace crevice
