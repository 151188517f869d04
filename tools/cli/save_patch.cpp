// SPDX-License-Identifier: MIT
// A config with the smallest patch over another.
#include "tools/cli/save_patch.h"

#include <crevice/config.h>

#include "core/base/text.h"
#include "core/config/joined_name.h"
#include "core/json/merge.h"
#include "core/json/override.h"
#include "tools/cli/output_request.h"
#include "tools/image/image_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace crevice {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kSuffix = ".json";

/// The config as `file` names it in `extends`: a shipped one by name, one on disk by a relative
/// path.
std::string extendsEntry(const std::string& config, const std::string& file)
{
    std::error_code error;
    if (!endsWith(config, kSuffix)) return config;
    if (!fs::exists(config, error)) return config.substr(0, config.size() - kSuffix.size());
    const auto whole = [&](const std::string& name) {
        return fs::weakly_canonical(fs::absolute(name, error), error);
    };
    const fs::path folder = whole(file).parent_path();
    const std::string path = whole(config).lexically_relative(folder).generic_string();
    return startsWith(path, "../") ? path : "./" + path;
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

Status checkPatchFile(const ConfigOptions& options, const std::string& file)
{
    std::error_code error;
    if (!endsWith(file, kSuffix))
        return Diagnostic{Code::usage, "--save-patch '" + file + "' does not end in .json"};
    if (fs::equivalent(options.config, file, error))
        return Diagnostic{Code::usage,
                          "--save-patch '" + file + "' is the config that it would extend"};
    return checkWritable(file);
}

Status savePatch(const ConfigOptions& options, const SourceSet& sources, const std::string& file)
{
    std::vector<std::string> added;  // modules, each with a plus in front
    auto extends = nlohmann::json::array();
    for (const std::string& name : splitName(options.config))
        extends.push_back(extendsEntry(name, file));
    for (const std::string& text : options.overrides) {
        if (!startsWith(text, "+")) continue;
        added.push_back(text);
        extends.push_back(extendsEntry(text.substr(1), file));
    }
    const Result<Node> base = loadConfig(sources, {options.config, {}, added, options.roots});
    if (!base) return base.diagnostics();
    Result<Node> now = loadConfig(sources, requestOf(options));
    if (!now) return now.diagnostics();
    const Result<Description> description = decode(*now, sources);
    if (!description) return description.diagnostics();
    for (const Diagnostic& each : description->unused) {  // what a swapped module took with it
        if (each.code != Code::unknown_param) continue;
        if (Status gone = applyOverride(*now, each.pointer + "=null"); !gone) return gone;
    }
    nlohmann::ordered_json json = {{"format", 1}, {"extends", extends}};
    auto patch = nlohmann::ordered_json::parse(toJson(patchBetween(*base, *now)));
    shorten(patch, *base);
    json.update(patch);
    return writeFile(file, json.dump(2) + '\n');
}

}  // namespace crevice
