// SPDX-License-Identifier: MIT
// "radius=0.8" as a patch.
#include "core/override.h"

#include "core/merge.h"
#include "core/text.h"

#include <algorithm>

namespace crevice {

namespace {

// The keys on the way to what an override sets.
Result<std::vector<std::string>> overrideKeys(const Node& document, const std::string& name,
                                              const Place& place)
{
    if (name[0] == '/') return pointerKeys(name);
    std::vector<std::string> names;
    for (const char* section : {"params", "features"}) {
        const Node* entries = document.find(section);
        if (!entries) continue;
        if (entries->find(name)) return std::vector<std::string>{section, name, "default"};
        for (const Member& member : entries->members()) names.push_back(member.key);
    }
    Diagnostic unknown{Code::unknown_param, "'" + name + "' is neither a param nor a feature",
                       place};
    unknown.help = suggestName(name, std::move(names), "params and features");
    return unknown;
}

}  // namespace

Status applyOverride(Node& document, const std::string& text)
{
    const std::size_t equals = text.find('=');
    const auto source = std::make_shared<SourceText>(
        SourceText{"--set " + text, text, "./--set"});  // its files stand in the current folder
    const Place place{source, 1, 1, static_cast<int>(std::min(equals, text.size()))};
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::override_syntax,
                          "found '" + text + "' where name=value was wanted", place, {}, {},
                          "write radius=0.8, or /passes/blur/when=null for any place"};
    const std::string name = text.substr(0, equals);
    const Result<std::vector<std::string>> keys = overrideKeys(document, name, place);
    if (!keys) return keys.diagnostics();

    // The name is blank while the value is read, so that columns count from the override's start.
    source->text = std::string(equals + 1, ' ') + text.substr(equals + 1);
    Result<Node> value = parseValue(source);
    source->text = text;
    if (!value) return value.diagnostics();
    Node patch = std::move(*value);
    for (auto key = keys->rbegin(); key != keys->rend(); ++key) {
        Node object;
        object.kind = Node::Kind::object;
        object.place = place;
        object.change().members.push_back({*key, place, std::move(patch)});
        patch = std::move(object);
    }
    Diagnostics errors;
    mergePatch(document, patch, errors);
    return errors;
}

}  // namespace crevice
