// SPDX-License-Identifier: MIT
// The files on disk that a config is made of, as the page reads, changes and saves them.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/watched_files.h"

#include <crevice/source.h>

#include <filesystem>
#include <mutex>

namespace crevice {

/// Where the files of a user's config are among the page's sources, which know no disk: mine.json
/// is "configs/mine.json", and all others lie to it as they do on disk, so that the names by which
/// they name one another lead to the same files.
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

struct UserFile {
    std::string path;  ///< Among the page's sources: "configs/mine.json".
    std::string text;
    std::string version;  ///< Changes with the text.
};

/// What became of a save.
struct Save {
    enum class End {
        done,
        changed,  ///< Not written: the file is no longer what the page knew.
        unknown,  ///< Not written: the config has no file of that name.
        failed,   ///< Not written: see `why`.
    };
    End end = End::done;
    UserFile file = {};  ///< As it is now; of `unknown` and `failed` empty.
    Diagnostics why = {};
};

/// From any thread. No other files than these are ever written.
class UserFiles {
public:
    /// Of a shipped config there are none. The shipped sources must outlive this.
    UserFiles(ConfigOptions options, const SourceSet& shipped);

    /// What the page is to load: "mine", "mobile+geometry/host_depth".
    const std::string& configName() const { return config_name_; }

    /// Whether the config is a file.
    bool editable() const { return paths_.has_value(); }

    /// All of them, with their texts as they are on disk now.
    std::vector<UserFile> all();

    /// Puts the text in the place of the file's, whole or not at all, where that still has the
    /// version.
    Save save(const std::string& path, const std::string& version, const std::string& text);

    /// Files that were edited by others since this was last asked, and those that the config has
    /// named since. To be asked several times a second.
    std::vector<UserFile> changes();

    /// What is wrong with the config and its shaders, as planForEveryScene has it.
    Diagnostics check() const;

private:
    std::vector<std::string> addNamed();
    std::optional<UserFile> fileOf(const std::string& file, const std::string& text) const;
    std::vector<std::string> filesAt(const std::string& path) const;

    ConfigOptions options_;
    const SourceSet& shipped_;
    std::optional<SourcePaths> paths_;  // of a config that is a file
    std::string config_name_;
    mutable std::mutex mutex_;
    WatchedFiles watched_{WatchedFiles::Of::config};
    bool saved_ = false;   // since `changes` was last asked
    bool broken_ = false;  // what the config names may then come into being
    int polls_ = 0;
};

}  // namespace crevice
