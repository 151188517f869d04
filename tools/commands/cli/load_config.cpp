// SPDX-License-Identifier: MIT
#include "tools/commands/cli/load_config.h"

#include "core/base/content_hash.h"
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/config/decode_report.h"
#include "core/config/values.h"
#include "core/json/merge.h"

#include <crevice/baked.h>
#include <crevice/shipped.h>

#include <nlohmann/json.hpp>

namespace crevice {
namespace {

constexpr std::string_view kBakedEnding = ".crevice";

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

/// Gives a param or feature of the description the value of "name=value". Errors: CV8001, and
/// those of checkValue.
Status setBaked(Description& description, const std::string& text)
{
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string name = text.substr(0, equals),
                      value = text.substr(std::min(equals + 1, text.size()));
    if (startsWith(text, "+"))
        return Diagnostic{Code::usage, "a baked effect takes no module, as '" + text + "'",
                          "it has those that it was baked with: leave out --host-depth, or bake "
                          "another"};
    const int feature = indexOf(description.features, name);
    const int param = indexOf(description.params, name);
    if (feature >= 0) {
        FeatureDesc& desc = description.features[static_cast<std::size_t>(feature)];
        const auto word = std::find(desc.values.begin(), desc.values.end(), value);
        if (word == desc.values.end())
            return Diagnostic{Code::usage, "'" + name + "' cannot be '" + value + "'",
                              suggestName(value, desc.values, name)};
        desc.value = static_cast<int>(word - desc.values.begin());
        applyLevel(description, name);
        return {};
    }
    if (param < 0)
        return Diagnostic{Code::usage, "the baked effect has no param '" + name + "'",
                          suggestName(name, namesOf(description.params), "params")};
    ParamDesc& desc = description.params[static_cast<std::size_t>(param)];
    const std::optional<double> number = parseNumber(value);
    const float first = static_cast<float>(number.value_or(0));
    if (!number && isLength(desc) && takeLength(value, desc.value)) return {};
    if (!number || componentCount(desc.type) != 1)
        return Diagnostic{Code::usage, "'" + value + "' is no number, as '" + name + "' has",
                          "write --set " + name + "=1"};
    if (Status fits = checkValue(desc, &first, 1); !fits) return fits;
    desc.value = {first};
    return {};
}

/// Reads "effect.crevice", or one of several configs of it, "effect.crevice:mobile".
Result<Description> loadBaked(const ConfigOptions& options)
{
    const std::size_t end = options.config.rfind(kBakedEnding) + kBakedEnding.size();
    const std::string file = options.config.substr(0, end);
    const FileBytes bytes = readBytes(file, 1u << 26);
    if (!bytes)
        return Diagnostic{Code::module_missing, "the file '" + file + "' " + absenceOf(file)};
    auto baked = readBaked(bytes.bytes.data(), bytes.bytes.size());
    if (!baked) return baked.diagnostics();
    auto one = bakedConfig(
        std::move(*baked),
        std::string_view(options.config).substr(std::min(end + 1, options.config.size())));
    if (!one) return one.diagnostics();
    one->description.limits = options.limits;
    for (const std::string& each : options.overrides)
        if (Status set = setBaked(one->description, each); !set) return set.diagnostics();
    return std::move(one->description);
}

}  // namespace

bool namesBaked(const ConfigOptions& options) { return has(options.config, kBakedEnding); }

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
    if (namesBaked(options)) return loadBaked(options);
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
