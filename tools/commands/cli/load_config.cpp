// SPDX-License-Identifier: MIT
#include "tools/commands/cli/load_config.h"

#include "core/base/content_hash.h"
#include "core/base/text.h"
#include "core/config/decode_report.h"
#include "core/config/values.h"
#include "core/json/merge.h"

#include <crevice/shipped.h>

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

void addNode(ContentHash& hash, const Node& node)
{
    hash.add(static_cast<int>(node.kind));
    hash.add(node.boolean);
    hash.add(node.number);
    hash.addText(node.kind == Node::Kind::string ? node.text : std::string());
    for (const Node& item : node.items) addNode(hash, item);
    for (const Member& member : node.members) {
        hash.addText(member.key);
        addNode(hash, member.value);
    }
}

/// Writes {"radius": {"default": 0.8}} as {"radius": 0.8} where the base declares it.
void shorten(nlohmann::ordered_json& patch, const Node& base)
{
    for (const char* section : {"params", "features"}) {
        const Node* declared = base.find(section);
        if (!declared || !patch.contains(section) || !patch[section].is_object()) continue;
        for (auto& [name, entry] : patch[section].items())
            if (declared->find(name) && entry.size() == 1 && entry.is_object() &&
                entry.contains("default") && !entry["default"].is_null())
                entry = nlohmann::ordered_json(entry["default"]);
    }
}

}  // namespace

LoadRequest requestOf(const ConfigOptions& options)
{
    return {options.config, options.variant, options.overrides, options.roots, options.limits};
}

void fitLengths(Description& description, const Node& document, const char* length)
{
    const auto own = [&](const std::string& pointer) {
        const Node* value = table::locate(document, pointer).node;
        const SourceRef source = value ? value->place.source : nullptr;
        const SourceRef shipped = source ? shippedSources().find(source->path) : nullptr;
        return source && !(shipped && shipped->text == source->text);
    };
    for (ParamDesc& param : description.params) {
        bool set = own("/params/" + param.name + "/default");
        for (const auto& path : levelPaths(document, param.name))
            set = set || own("/" + joined(path, "/"));
        if (!isLength(param) || set) continue;
        takeLength(length, param.value);
        param.value[3] = 8;
    }
}

Result<Description> loadDescription(const ConfigOptions& options, const SourceSet& sources,
                                    bool fits, const char* length)
{
    const Result<Node> document = loadConfig(sources, requestOf(options));
    if (!document) return document.diagnostics();
    Result<Description> description = decode(*document, sources, options.limits);
    if (description && fits) fitLengths(*description, *document, length);
    return description;
}

Result<LoadedConfig> loadWithContent(const ConfigOptions& options, const SourceSet& sources,
                                     bool file_scene)
{
    const Result<Node> document = loadConfig(sources, requestOf(options));
    if (!document) return document.diagnostics();
    Result<Description> description = decode(*document, sources, options.limits);
    if (!description) return description.diagnostics();
    if (file_scene) fitLengths(*description, *document, kShareOfScene);
    ContentHash hash;
    addNode(hash, *document);
    for (const auto& [path, source] : description->files) {
        hash.addText(path);
        hash.addText(source->text);
    }
    return LoadedConfig{std::move(*description), hash.hex()};
}

Result<std::string> patchText(const Node& base, Node now, const std::vector<std::string>& extends,
                              const SourceSet& sources)
{
    const Result<Description> description = decode(now, sources);
    if (!description) return description.diagnostics();
    for (const Diagnostic& each : description->unused) {  // what a swapped module took with it
        if (each.code != Code::unknown_param) continue;
        if (Status gone = applyOverride(now, each.pointer + "=null"); !gone)
            return gone.diagnostics();
    }
    nlohmann::ordered_json json = {{"format", 1}, {"extends", extends}};
    auto patch = nlohmann::ordered_json::parse(toJson(patchBetween(base, now)));
    shorten(patch, base);
    json.update(patch);
    return json.dump(2) + '\n';
}

}  // namespace crevice
