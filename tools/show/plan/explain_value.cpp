// SPDX-License-Identifier: MIT
// Finding a value in a merged document and telling which files set it.
#include "tools/show/plan/print.h"

#include "core/base/text.h"
#include "core/json/merge.h"

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

/// The keys of a pointer, or of a dotted path.
std::vector<std::string> partsOf(const std::string& path)
{
    if (startsWith(path, "/")) return pointerKeys(path);
    const std::vector<std::string_view> parts = split(path, '.');
    return {parts.begin(), parts.end()};
}

/// The initial word of a feature.
std::string initialWord(const Node& feature)
{
    const Node* value = feature.find("default");
    const Node* words = feature.find("values");
    if (!value && words && !words->items.empty()) value = &words->items.front();
    return !value ? "false" : value->kind == Node::Kind::boolean ? brief(*value) : value->text;
}

bool isBareName(const Node& document, const std::vector<std::string>& parts)
{
    return parts.size() == 1 && !document.find(parts[0]);
}

/// The default of the param or feature of that name; empty where there is none.
std::vector<std::string> defaultPath(const Node& document, const std::string& name)
{
    for (const char* group : {"params", "features"}) {
        const Node* values = document.find(group);
        if (values && values->find(name)) return {group, name, "default"};
    }
    return {};
}

/// "radius" stands for the default of the param or feature of that name, or for the value at the
/// initial level that sets it.
std::vector<std::string> expandBareName(const Node& document, std::vector<std::string> parts)
{
    if (!isBareName(document, parts)) return parts;
    for (const std::vector<std::string>& path : levelPaths(document, parts[0]))
        if (initialWord(*document.find("features")->find(path[1])) == path[3]) return path;
    const std::vector<std::string> path = defaultPath(document, parts[0]);
    return path.empty() ? parts : path;
}

/// "imports.velocity" for "velocity": what has that name in some section of the document.
std::vector<std::string> pathsTo(const Node& document, const std::string& name)
{
    std::vector<std::string> paths;
    for (const Member& section : document.members)
        if (section.value.find(name)) paths.push_back("'" + section.key + "." + name + "'");
    return paths;
}

const Node* child(const Node& node, const std::string& part)
{
    if (node.kind != Node::Kind::array) return node.find(part);
    const bool number = !part.empty() && part.size() < 9 && allOf(part, isDigit);
    const std::size_t index = number ? std::stoul(part) : node.items.size();
    return index < node.items.size() ? &node.items[index] : nullptr;
}

/// The null of a patch that took the member away, or null.
const Member* deletedFrom(const Node& node, const std::string& part)
{
    for (auto gone = node.deleted.rbegin(); gone != node.deleted.rend(); ++gone)
        if (gone->key == part) return &*gone;
    return nullptr;
}

std::vector<std::string> childNames(const Node& node)
{
    std::vector<std::string> names;
    for (const Member& member : node.members) names.push_back(member.key);
    for (std::size_t i = 0; i < node.items.size(); ++i) names.push_back(std::to_string(i));
    return names;
}

std::string pointerOf(const std::vector<std::string>& parts)
{
    std::string pointer;
    for (const std::string& part : parts) pointer = memberPointer(pointer, part);
    return pointer;
}

/// The value that the path leads to, or null.
const Node* nodeAt(const Node& document, const std::vector<std::string>& path)
{
    const Node* node = &document;
    for (const std::string& part : path) node = node ? child(*node, part) : nullptr;
    return node;
}

/// What a bare name finds where a level sets it: the default, unless that is the same value.
std::vector<FoundValue> overruledBy(const Node& document, const std::string& name,
                                    const FoundValue& found)
{
    const std::vector<std::string> path = defaultPath(document, name);
    const Node* node = path.empty() ? nullptr : nodeAt(document, path);
    if (!node || brief(*node) == brief(*found.node)) return {};
    return {{pointerOf(path), node}};
}

/// The text at a place, or "" where the place is nowhere.
std::string textAt(const Place& place)
{
    if (!place.source || place.line < 1) return {};
    const std::string_view line = lineOf(place.source->text, place.line);
    const std::size_t begin = std::min(line.size(), static_cast<std::size_t>(place.column) - 1);
    return std::string(line.substr(begin, static_cast<std::size_t>(place.length)));
}

/// Where the value stands now, then what it replaced, the newest first.
std::vector<Place> placesOf(const Node& node)
{
    std::vector<Place> places = {node.place};
    places.insert(places.end(), node.origins.rbegin(), node.origins.rend());
    return places;
}

using Json = nlohmann::ordered_json;

nlohmann::json jsonOf(const FoundValue& value)
{
    nlohmann::json json = {{"pointer", value.pointer}, {"value", brief(*value.node)}};
    for (const Place& place : placesOf(*value.node))
        json["places"].push_back({{"file", place.source ? place.source->name : ""},
                                  {"line", place.line},
                                  {"column", place.column},
                                  {"text", textAt(place)}});
    for (const Member& member : value.node->members)
        json["members"].push_back(
            jsonOf({memberPointer(value.pointer, member.key), &member.value}));
    for (const FoundValue& each : value.overruled) json["overruled"].push_back(jsonOf(each));
    return json;
}

/// Of a param or feature; `word` is a feature's where no file says its default.
template <class Desc>
Json settingJson(const Node& document, const Desc& its, const std::string& word, const Json& range)
{
    const std::string pointer = its.pointer + "/default";
    const Result<FoundValue> own = findValue(document, pointer);
    const auto found = document.find(its.name) ? own : findValue(document, its.name);
    const Place& place = found ? found->node->place : its.place;
    const SourceRef file = own ? placesOf(*own->node).back().source : nullptr;
    const Result<Node> first = file ? parseDocument(file) : document;
    const Result<FoundValue> declared = findValue(first ? *first : document, pointer);
    Json json = {{"name", its.name}, {"label", its.label}};
    json["value"] = found ? Json::parse(toJson(*found->node)) : Json(word);
    json["default"] = declared ? Json::parse(toJson(*declared->node)) : Json(word);
    json.update(range);
    json["set_by"] = place.source ? placeName(place) : "the command line";
    json["help"] = its.tooltip;
    return json;
}

}  // namespace

Result<Json> settingsJson(const SourceSet& sources, const LoadRequest& request)
{
    const Result<Node> document = loadConfig(sources, request);
    if (!document) return document.diagnostics();
    const Result<Description> description = decode(*document, sources, request.limits);
    if (!description) return description.diagnostics();
    Json all = {{"params", Json::array()}, {"features", Json::array()}};
    for (const ParamDesc& each : description->params) {
        const double most = each.soft_max > 0 ? each.soft_max : each.max;
        all["params"].push_back(settingJson(
            *document, each, "",
            {{"unit", each.unit}, {"min", each.min}, {"max", each.max}, {"soft_max", most}}));
    }
    for (const FeatureDesc& each : description->features)
        all["features"].push_back(
            settingJson(*document, each, each.values[each.value], {{"values", each.values}}));
    return all;
}

Result<FoundValue> findValue(const Node& document, const std::string& path)
{
    FoundValue found{{}, &document};
    const std::vector<std::string> parts = partsOf(path);
    for (const std::string& part : expandBareName(document, parts)) {
        const Node* next = child(*found.node, part);
        if (!next) {
            Diagnostic error{Code::reference_missing,
                             "there is no '" + part + "' in " +
                                 (found.pointer.empty() ? "the config" : found.pointer)};
            error.pointer = found.pointer;
            if (const Member* gone = deletedFrom(*found.node, part))
                error.notes.push_back({gone->key_place, "it was deleted here"});
            std::vector<std::string> names = childNames(*found.node);
            if (found.node == &document)
                for (const char* section : {"params", "features"})
                    if (const Node* all = document.find(section))
                        for (const Member& each : all->members) names.push_back(each.key);
            error.help = suggestName(part, std::move(names), "keys");
            if (const auto paths = pathsTo(document, part); !paths.empty() && parts.size() == 1)
                error.help = "did you mean " + joined(paths, " or ") + "?";
            return error;
        }
        found = {memberPointer(found.pointer, part), next};
    }
    if (isBareName(document, parts)) found.overruled = overruledBy(document, parts[0], found);
    return found;
}

std::string explainText(const FoundValue& value)
{
    std::string text;
    for (const Member& member : value.node->members)
        text += explainText(FoundValue{memberPointer(value.pointer, member.key), &member.value});
    if (!text.empty()) return text;
    text = value.pointer + " is " + brief(*value.node) + '\n';
    const char* verb = "set";
    for (const Place& place : placesOf(*value.node)) {
        const std::string where = placeName(place);
        const std::string what = textAt(place);
        text += std::string("  ") + verb + " by " + (where.empty() ? "the command line" : where);
        text += (what.empty() ? "" : ": " + what) + '\n';
        verb = "before that";
    }
    for (const FoundValue& each : value.overruled) text += "and not " + explainText(each);
    return text;
}

std::string explainJson(const FoundValue& value)
{
    const auto replaced = nlohmann::json::error_handler_t::replace;
    return jsonOf(value).dump(2, ' ', false, replaced) + '\n';
}

}  // namespace crevice
