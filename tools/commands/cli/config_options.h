// SPDX-License-Identifier: MIT
// Which config a command works on: the arguments that render, validate and explain share.
#pragma once

#include "tools/commands/cli/load_config.h"

#include <crevice/config.h>
#include <crevice/shipped.h>

#include <functional>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace crevice {

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

/// Checks what can be known before drawing. Errors: CV8001 where `file` is the config or does not
/// end in .json, CV7007 where it cannot be written.
Status checkPatchFile(const ConfigOptions& options, const std::string& file);

/// Writes a config that extends the options' config and has, beyond it, the smallest patch with
/// which it loads as the config does with the options' variant and overrides. Errors: those of
/// loadConfig, CV7007.
Status savePatch(const ConfigOptions& options, const SourceSet& sources, const std::string& file);

}  // namespace crevice
