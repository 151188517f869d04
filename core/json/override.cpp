// SPDX-License-Identifier: MIT
// "radius=0.8" as a patch.
#include "core/json/override.h"

#include "core/base/text.h"
#include "core/json/merge.h"

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
        // A bare value that no object has been laid under declares nothing.
        const Node* declared = entries->find(name);
        if (declared && declared->kind == Node::Kind::object)
            return std::vector<std::string>{section, name, "default"};
        for (const Member& member : entries->members) names.push_back(member.key);
    }
    return Diagnostic{Code::unknown_param, "'" + name + "' is neither a param nor a feature",
                      suggestName(name, std::move(names), "params and features"), place};
}

std::shared_ptr<SourceText> sourceOf(const std::string& text, std::vector<std::string> roots)
{
    roots.push_back(".");  // where its files stand
    auto source = std::make_shared<SourceText>(SourceText{"--set " + text, text, kOverridePath});
    source->roots = std::make_shared<const std::vector<std::string>>(std::move(roots));
    return source;
}

}  // namespace

Place overridePlace(const std::string& text, const std::vector<std::string>& roots)
{
    return {sourceOf(text, roots), 1, 1, static_cast<int>(text.size())};
}

Result<Override> readOverride(const std::string& text, const std::vector<std::string>& roots)
{
    const std::size_t equals = text.find('=');
    const std::shared_ptr<SourceText> source = sourceOf(text, roots);
    const Place place{source, 1, 1, static_cast<int>(std::min(equals, text.size()))};
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::override_syntax, "found '" + text + "' where name=value was wanted",
                          "write radius=0.8, or /passes/blur/when=null for any place", place};

    const std::size_t second = text.find('=', equals + 1), gap = text.find_last_of(" ,", second);
    if (second != text.npos && gap != text.npos && gap > equals &&
        text.find_first_of("[{\"") == text.npos)
        return Diagnostic{Code::override_syntax, "found two values where one name=value was wanted",
                          "write --set " + text.substr(0, text.find_first_of(" ,", equals)) +
                              " --set " + text.substr(gap + 1),
                          place};

    // The name is blank while the value is read, so that columns count from the override's start.
    source->text = std::string(equals + 1, ' ') + text.substr(equals + 1);
    Result<Node> value = parseValue(source);
    source->text = text;
    if (!value) return value.diagnostics();
    return Override{text.substr(0, equals), place, std::move(*value)};
}

std::vector<std::vector<std::string>> levelPaths(const Node& document, const std::string& name)
{
    std::vector<std::vector<std::string>> paths;
    const Node* features = document.find("features");
    for (const Member& feature : features ? features->members : std::vector<Member>())
        if (const Node* sets = feature.value.find("sets"))
            for (const Member& word : sets->members)
                if (word.value.find(name))
                    paths.push_back({"features", feature.key, "sets", word.key, name});
    return paths;
}

Status applyOverride(Node& document, const std::string& text, const std::vector<std::string>& roots)
{
    Result<Override> read = readOverride(text, roots);
    if (!read) return read.diagnostics();
    const Result<std::vector<std::string>> keys = overrideKeys(document, read->name, read->place);
    if (!keys) return keys.diagnostics();
    Diagnostics errors;
    const auto set = [&](const std::vector<std::string>& path) {
        Node patch = read->value;
        for (auto key = path.rbegin(); key != path.rend(); ++key)
            patch = objectOf(*key, read->place, std::move(patch));
        mergePatch(document, patch, errors);
    };
    set(*keys);
    if (read->name[0] != '/')  // a value by its name stands over all levels
        for (const std::vector<std::string>& path : levelPaths(document, read->name)) set(path);
    return errors;
}

}  // namespace crevice
