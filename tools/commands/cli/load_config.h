// SPDX-License-Identifier: MIT
// A config with what a command sets in it, as a description.
#pragma once

#include "tools/commands/cli/scene_lengths.h"

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

}  // namespace crevice
