// SPDX-License-Identifier: MIT
// Which files a scene may name: regular ones below its own folder, or below one that was allowed.
#pragma once

#include <crevice/diagnostic.h>

#include <cstdint>
#include <filesystem>
#include <set>

namespace crevice {

struct ImportOptions;

class SceneFolder {
public:
    SceneFolder(const std::string& scene, const ImportOptions& options);

    /// The scene itself, or a regular file that lies, after symlinks, below one of the folders.
    bool allows(const std::filesystem::path& file) const;

    /// Whether there is such a file elsewhere; it is kept for `warning` then.
    bool refuses(const std::filesystem::path& file);

    /// Counts its size, once; this process may then take what that allows (readerLimits).
    void opens(const std::filesystem::path& file);

    /// Keeps the name of the first file of materials that is not there, until one is opened.
    void lacks(const std::string& file) { lacking_ = lacking_.empty() ? file : lacking_; }
    const std::string& lacking() const { return lacking_; }

    const std::set<std::string>& opened() const { return opened_; }

    /// Of the scene and of all that was opened.
    std::uint64_t bytes() const { return bytes_; }

    bool refusedAny() const { return !refused_.empty(); }

    /// CV1204, which names what was refused. Requires refusedAny().
    Diagnostic warning() const;

private:
    std::string scene_;
    const ImportOptions& options_;
    std::vector<std::string> roots_;
    std::set<std::string> refused_;
    std::set<std::string> opened_;
    std::string lacking_;
    std::uint64_t bytes_ = 0;
};

}  // namespace crevice
