// SPDX-License-Identifier: MIT
// Loading a config: its `extends`, itself, a variant and overrides, merged into one document.
#pragma once

#include "core/json/document.h"

#include <string>
#include <vector>

namespace crevice {

constexpr int kMaxExtendsDepth = 8;

/// What to load and what to lay over it.
struct LoadRequest {
    std::string config;  ///< A shipped config's name ("learnopengl"), or the path of a file.
    std::string variant = {};  ///< A name under `variants`; empty for none.
    std::vector<std::string> overrides = {};  ///< "radius=0.8": a param's default or a feature's,
                                              ///< or a pointer, "/passes/blur/when=null",
                                              ///< or a module that the config or a config that it extends
                                              ///< names, and another: "filter/box=filter/median".
    std::vector<std::string> roots = {};  ///< Folders below which files may be named besides those below the
                                          ///< config's own folder, and for an override's value those below the
                                          ///< current one. A folder that does not exist allows nothing.
};

/// Finds the config and everything that it extends, and merges them: modules from left to right,
/// then the file, then the variant, then the overrides. The result has neither `extends` nor
/// `variants`, nor the `$schema` by which editors find what checks a file; its top keeps the file's
/// place, as an origin too where a variant or a pointer's override was laid over it. A name is looked up
/// as "configs/NAME.json" in `sources`; what ends in ".json" is a file on disk first. `extends` entries
/// are module names ("ssao/hemisphere", found as "ssao/hemisphere.json" in `sources`), config names,
/// or paths relative to the file ("./mine.json"), to what lies, once links are resolved, below the config's own
/// folder or one of `roots`; the same holds for the GLSL files that `decode` reads. Two files, neither of which extends the other, may
/// not make one shader or interface: that is two filters or two estimators, of which a merge would
/// keep halves.
///
/// Errors: CV1xxx of any file, CV1201 to CV1208, CV4004 for an override of nothing.
Result<Node> loadConfig(const SourceSet& sources, const LoadRequest& request);

/// The names of the variants that a config and all that it extends declare, sorted; none where it cannot
/// be read. Of the request, `config` and `roots` count.
std::vector<std::string> variantNames(const SourceSet& sources, const LoadRequest& request);

/// The names of the configs in `sources`, sorted.
std::vector<std::string> configNames(const SourceSet& sources);

}  // namespace crevice
