// SPDX-License-Identifier: MIT
#include "tools/commands/cli/save_patch.h"

#include "core/base/text.h"
#include "tools/commands/cli/output_request.h"
#include "tools/commands/cli/patch_text.h"
#include "tools/render/image/image_file.h"

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

}  // namespace

Status checkPatchFile(const ConfigOptions& options, const std::string& file)
{
    std::error_code error;
    if (!endsWith(file, kSuffix))
        return Diagnostic{Code::usage, "--save-patch '" + file + "' does not end in .json",
                          "write --save-patch " + file + ".json"};
    if (fs::equivalent(options.config, file, error))
        return Diagnostic{Code::usage,
                          "--save-patch '" + file + "' is the config that it would extend"};
    return checkWritable(file);
}

Status savePatch(const ConfigOptions& options, const SourceSet& sources, const std::string& file)
{
    std::vector<std::string> added;  // modules, each with a plus in front
    std::vector<std::string> extends;
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
    const Result<std::string> text = patchText(*base, *now, extends, sources);
    if (!text) return text.diagnostics();
    return writeFile(file, *text);
}

}  // namespace crevice
