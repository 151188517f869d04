// SPDX-License-Identifier: MIT
// Where the files of a user's config are among the page's sources, which know no disk: mine.json is
// "configs/mine.json", and all others lie to it as they do on disk, so that the names by which they
// name one another lead to the same files.
#pragma once

#include <crevice/source.h>

#include <filesystem>

namespace crevice {

class SourcePaths {
public:
    /// Of a config's file, which may name files below its own folder and the `roots`: the lowest
    /// folder that holds them all is "configs/". Where that has a file named like a shipped config
    /// it is a folder in it, so that the shipped one is not hidden.
    SourcePaths(const std::string& config_file, const std::vector<std::string>& roots,
                const SourceSet& shipped);

    /// Empty for a file that lies elsewhere, or that would hide a shipped one.
    std::string of(const std::string& file) const;

    /// The name by which the config is loaded: "mine" of "configs/mine.json".
    const std::string& configName() const { return config_name_; }

private:
    const SourceSet& shipped_;
    std::filesystem::path top_;  // what is "configs/", or the folder in it
    std::string folder_ = "configs/";
    std::string config_name_;
};

}  // namespace crevice
