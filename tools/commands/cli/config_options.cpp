// SPDX-License-Identifier: MIT
#include "tools/commands/cli/config_options.h"

#include <crevice/compile.h>

#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>

namespace crevice {
namespace {

/// What a host may have of a surface, and the module that reads it.
constexpr struct HostSurface {
    const char* word;
    const char* module;
} kHostSurfaces[] = {
    {"depth", "geometry/host_depth"},
    {"normals", "geometry/host_depth_normal"},
    {"linear", "geometry/host_linear_depth"},
    {"linear_normals", "geometry/host_linear_depth_normal"},
    {"log", "geometry/host_log_depth"},
    {"log_normals", "geometry/host_log_depth_normal"},
    {"positions", "geometry/host_position_normal"},
};

/// CLI11's kind of check, which also sets the limit: "passes=500".
std::string setLimit(const std::string& text, Limits& limits)
{
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto number = equals == text.npos ? std::nullopt : parseNumber(text.substr(equals + 1));
    if (!number || !(*number >= 1 && *number <= 1e15))
        return "'" + text +
               "' is no limit: write passes=500, files=, targets= or, without a unit, "
               "bytes=1048576";
    if (name == "bytes") return limits.bytes = *number, "";
    for (const auto& [known, limit] :
         {std::pair("files", &limits.files), std::pair("passes", &limits.passes),
          std::pair("targets", &limits.targets)})
        if (name == known) return *limit = static_cast<int>(std::min(*number, 1e9)), "";
    return suggestName(name, {"bytes", "files", "passes", "targets"}, "limits");
}

void addLimitOption(CLI::App& app, Limits& limits)
{
    app.add_option_function<std::vector<std::string>>(
           "--limit", [](const std::vector<std::string>&) {},
           "Let a config ask for more, or for less: files=1024, passes=512, targets=512, "
           "bytes=2147483648 (of its textures); may be repeated")
        ->type_name("NAME=COUNT")
        ->allow_extra_args(false)
        ->check([&limits](const std::string& text) { return setLimit(text, limits); });
}

/// CLI11's kind of check: "" is fine, anything else is what is wrong.
std::string isCheckout(const std::string& folder)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(folder + "/effects", ignored)) return {};
    if (std::filesystem::is_directory(folder + "/configs", ignored)) return {};
    return "the folder '" + folder +
           "' has neither effects/ nor configs/: name the one that has them";
}

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

void addConfigOptions(CLI::App& app, ConfigOptions& options)
{
    addVariantOption(app, options.variant);
    addList(app, "--set", options.overrides, "NAME=VALUE",
            "Set a param or feature (radius=0.8, radius=5%), or any value by its JSON pointer "
            "(/passes/blur/when=null); may be repeated");
    addHostDepthOption(app, options.overrides);
    addCheckoutOption(app, options.checkout);
    addRootOption(app, options.roots);
    addLimitOption(app, options.limits);
}

std::function<std::string(const std::string&)> aboveZero(const std::string& example)
{
    return [example](const std::string& text) {
        const double number = parseNumber(text).value_or(0.0);
        if (number > 0.0 && std::isfinite(number)) return std::string();
        return "'" + text + "' is not a number above 0, without a unit, as in " + example;
    };
}

CLI::Option* addText(CLI::App& app, const char* name, std::string& value, const char* kind,
                     const std::string& about)
{
    return app.add_option(name, value, about)->type_name(kind)->capture_default_str();
}

CLI::Option* addList(CLI::App& app, const char* name, std::vector<std::string>& values,
                     const char* kind, const std::string& about)
{
    return app.add_option(name, values, about)->type_name(kind)->allow_extra_args(false);
}

void addVariantOption(CLI::App& app, std::string& variant)
{
    app.add_option("--variant", variant, "Name of a variant that the config declares");
}

void addHostDepthOption(CLI::App& app, std::vector<std::string>& overrides)
{
    std::string words;
    std::map<std::string, std::string> modules;
    for (const HostSurface& each : kHostSurfaces) {
        words += std::string(words.empty() ? "" : ", ") + each.word;
        modules[each.word] = std::string("+") + each.module;
    }
    const std::string about =
        "Run the config on textures that a host would hand over, drawn by the command: " + words +
        ", as --host-depth=normals; alone: depth";
    app.add_flag("--host-depth{depth}", about)
        ->check(CLI::IsMember(modules))
        ->each([&overrides, modules](const std::string& word) {
            overrides.push_back(modules.at(word));
        });
}

void addCheckoutOption(CLI::App& app, std::string& checkout)
{
    addText(app, "--effects", checkout, "FOLDER",
            "Folder whose effects/ and configs/ are read before the embedded ones")
        ->check(isCheckout);
}

void addRootOption(CLI::App& app, std::vector<std::string>& roots)
{
    if (CLI::Option* known = app.get_option_no_throw("--root")) {
        known->each([&roots](const std::string& folder) { roots.push_back(folder); });
        return;
    }
    addList(
        app, "--root", roots, "FOLDER",
        "Let configs and scenes read files below this folder too, beside those below their own; "
        "may be repeated")
        ->check(CLI::ExistingDirectory);
}

void addDisableOption(CLI::App& app, std::vector<std::string>& disable)
{
    std::vector<std::string> names;
    std::string listed;
    for (const Optimization& optimization : kOptimizations) {
        names.push_back(optimization.name);
        listed += std::string(optimization.name) + ", ";
    }
    names.push_back("all");
    addList(app, "--disable", disable, "NAME",
            "Switch off an optimization: " + listed + "or all; may be repeated")
        ->check(CLI::IsMember(names));
}

Status checkPatchFile(const ConfigOptions& options, const std::string& file)
{
    std::error_code error;
    if (!endsWith(file, kSuffix))
        return Diagnostic{Code::usage, "the config '" + file + "' does not end in .json",
                          "name it " + file + ".json"};
    if (fs::equivalent(options.config, file, error))
        return Diagnostic{Code::usage, "'" + file + "' is the config that it would extend"};
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
