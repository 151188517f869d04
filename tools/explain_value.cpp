// SPDX-License-Identifier: MIT
// Finding a value in a merged document and telling which files set it.
#include "tools/explain_value.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace crevice {
namespace {

/// The parts of a pointer, unescaped, or of a dotted path.
std::vector<std::string> partsOf(const std::string& path)
{
    const bool pointer = !path.empty() && path[0] == '/';
    std::vector<std::string> parts(1);
    for (std::size_t i = pointer ? 1 : 0; i < path.size(); ++i) {
        if (path[i] == (pointer ? '/' : '.')) {
            parts.emplace_back();
        } else if (pointer && path[i] == '~' && i + 1 < path.size()) {
            parts.back() += path[++i] == '1' ? '/' : '~';
        } else {
            parts.back() += path[i];
        }
    }
    return parts;
}

/// "radius" stands for the default of the param or feature of that name.
std::vector<std::string> expandBareName(const Node& document, std::vector<std::string> parts)
{
    if (parts.size() != 1 || document.find(parts[0])) return parts;
    for (const char* group : {"params", "features"}) {
        const Node* values = document.find(group);
        if (values && values->find(parts[0])) return {group, parts[0], "default"};
    }
    return parts;
}

const Node* child(const Node& node, const std::string& part)
{
    if (node.kind != Node::Kind::array) return node.find(part);
    const bool number = !part.empty() && part.size() < 9 &&
                        std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t index = number ? std::stoul(part) : node.items.size();
    return index < node.items.size() ? &node.items[index] : nullptr;
}

std::vector<std::string> childNames(const Node& node)
{
    std::vector<std::string> names;
    for (const Member& member : node.members) names.push_back(member.key);
    for (std::size_t i = 0; i < node.items.size(); ++i) names.push_back(std::to_string(i));
    return names;
}

std::string escaped(const std::string& part)
{
    std::string text;
    for (char c : part) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

/// The text at a place, or "" where the place is nowhere.
std::string textAt(const Place& place)
{
    if (!place.source || place.line < 1) return {};
    const std::string& text = place.source->text;
    std::size_t begin = 0;
    for (int line = 1; line < place.line; ++line) {
        begin = text.find('\n', begin);
        if (begin == std::string::npos) return {};
        ++begin;
    }
    begin = std::min(text.size(), begin + static_cast<std::size_t>(place.column) - 1);
    const std::string found = text.substr(begin, static_cast<std::size_t>(place.length));
    return found.substr(0, found.find('\n'));
}

/// Where the value stands now, then what it replaced, the newest first.
std::vector<Place> placesOf(const Node& node)
{
    std::vector<Place> places = {node.place};
    places.insert(places.end(), node.origins.rbegin(), node.origins.rend());
    return places;
}

}  // namespace

Result<FoundValue> findValue(const Node& document, const std::string& path)
{
    FoundValue found{{}, &document};
    for (const std::string& part : expandBareName(document, partsOf(path))) {
        const Node* next = child(*found.node, part);
        if (!next) {
            Diagnostic error{Code::reference_missing,
                             "there is no '" + part + "' in " +
                                 (found.pointer.empty() ? "the config" : found.pointer)};
            error.pointer = found.pointer;
            error.help = suggestName(part, childNames(*found.node), "keys");
            return error;
        }
        found = {found.pointer + '/' + escaped(part), next};
    }
    return found;
}

std::string explainText(const FoundValue& value)
{
    std::string text = value.pointer + " is " + brief(*value.node) + '\n';
    const char* verb = "set";
    for (const Place& place : placesOf(*value.node)) {
        const std::string where = placeName(place);
        const std::string what = textAt(place);
        text += std::string("  ") + verb + " by " + (where.empty() ? "the command line" : where);
        text += (what.empty() ? "" : ": " + what) + '\n';
        verb = "before that";
    }
    return text;
}

std::string explainJson(const FoundValue& value)
{
    nlohmann::json places = nlohmann::json::array();
    for (const Place& place : placesOf(*value.node))
        places.push_back({{"file", place.source ? place.source->name : ""},
                          {"line", place.line},
                          {"column", place.column},
                          {"text", textAt(place)}});
    const nlohmann::json json = {
        {"pointer", value.pointer}, {"value", brief(*value.node)}, {"places", places}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace crevice
