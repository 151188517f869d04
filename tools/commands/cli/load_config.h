// SPDX-License-Identifier: MIT
// A config with what a command sets in it, as a description, and the smallest patch between two.
#pragma once

#include <crevice/config.h>

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

/// The radius of a scene whose units nobody knows: two thirds of what 0.5 is of the scene 'room'.
constexpr const char* kShareOfScene = "5%";

/// Makes lengths that only files as shipped set `length`, such as "5%", and at most 8 % of the
/// view's height at its median depth: who stands in a city does not see all of it. `document` is
/// the description's.
void fitLengths(Description& description, const Node& document, const char* length);

/// Whether it is a baked effect, "effect.crevice" or one config of it, "effect.crevice:mobile".
bool namesBaked(const ConfigOptions& options);

/// Loads, merges, decodes, and where it `fits` has lengths fitted to `length`. Errors: those of
/// loadConfig and decode.
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

/// A config that extends these and says, beyond them, only in what `now` differs from `base`. What
/// a module that was swapped took with it is left out. Errors: those of decode, for `now`.
Result<std::string> patchText(const Node& base, Node now, const std::vector<std::string>& extends,
                              const SourceSet& sources);

}  // namespace crevice
