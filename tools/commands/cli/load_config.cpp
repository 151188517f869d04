// SPDX-License-Identifier: MIT
#include "tools/commands/cli/load_config.h"

#include "core/base/content_hash.h"

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

}  // namespace

LoadRequest requestOf(const ConfigOptions& options)
{
    return {options.config, options.variant, options.overrides, options.roots, options.limits};
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

}  // namespace crevice
