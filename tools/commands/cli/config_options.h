// SPDX-License-Identifier: MIT
// Which config a command works on: the arguments that render, validate and explain share.
#pragma once

#include "tools/commands/cli/scene_lengths.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

#include <functional>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace crevice {

struct ConfigOptions {
    std::string config;                   ///< A shipped config's name or a file.
    std::string variant;                  ///< --variant
    std::vector<std::string> overrides;   ///< --set, each "name=value"
    std::string checkout;                 ///< --effects; empty for the embedded modules alone
    std::vector<std::string> roots = {};  ///< --root
    Limits limits = {};                   ///< --limit
};

/// What to load, as core has it.
LoadRequest requestOf(const ConfigOptions& options);

/// Adds --variant, --set, --host-depth, --effects, --root and --limit; CONFIG is left to the
/// command, since validate takes several.
void addConfigOptions(CLI::App& app, ConfigOptions& options);

/// CLI11's kind of check for a finite number above 0; `example` is how one writes it.
std::function<std::string(const std::string&)> aboveZero(const std::string& example);

/// Adds an option that takes a word of that kind; --help shows the value that it has before, if
/// any.
CLI::Option* addText(CLI::App& app, const char* name, std::string& value, const char* kind,
                     const std::string& about);

/// Adds an option that may be repeated, each time with one value.
CLI::Option* addList(CLI::App& app, const char* name, std::vector<std::string>& values,
                     const char* kind, const std::string& about);

/// Adds --host-depth, which lays a module over configs: "+geometry/host_depth".
void addHostDepthOption(CLI::App& app, std::vector<std::string>& overrides);

void addVariantOption(CLI::App& app, std::string& variant);    ///< --variant
void addCheckoutOption(CLI::App& app, std::string& checkout);  ///< --effects

/// Adds --root alone; added twice, for a config and a scene, it is one option that fills both.
void addRootOption(CLI::App& app, std::vector<std::string>& roots);

/// Adds --disable: optimizations of <crevice/compile.h> that are switched off.
void addDisableOption(CLI::App& app, std::vector<std::string>& disable);

/// Loads, merges, decodes, and for what is no built-in scene fits lengths to `length`
/// (scene_lengths.h). Errors: those of loadConfig and decode.
Result<Description> loadDescription(const ConfigOptions& options, const SourceSet& sources,
                                    bool fits = false, const char* length = kShareOfScene);

/// A config with its overrides in force.
struct LoadedConfig {
    Description description;
    std::string content;  ///< A hash over its document and its GLSL.
};

/// As loadDescription.
Result<LoadedConfig> loadWithContent(const ConfigOptions& options, const SourceSet& sources,
                                     bool file_scene = false);

/// Checks what can be known before drawing. Errors: CV8001 where `file` is the config or does not
/// end in .json, CV7007 where it cannot be written.
Status checkPatchFile(const ConfigOptions& options, const std::string& file);

/// Writes a config that extends the options' config and has, beyond it, the smallest patch with
/// which it loads as the config does with the options' variant and overrides. Errors: those of
/// loadConfig, CV7007.
Status savePatch(const ConfigOptions& options, const SourceSet& sources, const std::string& file);

}  // namespace crevice
