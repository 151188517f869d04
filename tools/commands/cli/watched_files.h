// SPDX-License-Identifier: MIT
// The files that a config was read from, watched for edits.
#pragma once

#include <crevice/config.h>

namespace crevice {

/// Finds edits by reading the files again: small ones, a few times a second. That needs no service
/// of the system's, works on every file system, and is not deceived by editors that write a new
/// file and rename it, or that save what was there before.
class WatchedFiles {
public:
    /// Which files of documents, descriptions and errors are added.
    enum class Of {
        all,     ///< Shipped modules too, where a folder on disk has them.
        config,  ///< The config, and what it names by paths on disk.
    };
    explicit WatchedFiles(Of of = Of::all) : of_(of) {}

    /// Adds a file by its path.
    void add(const std::string& path);

    /// Adds every file on disk that has a part in the document, the description or the errors.
    void add(const Node& document);
    void add(const Description& description);
    void add(const Diagnostics& diagnostics);

    /// Whether any of them differs from when this was last asked, or from when it was added. A file
    /// that cannot be read just now has not changed.
    bool changed() { return !changes().empty(); }

    /// The paths of those.
    std::vector<std::string> changes();

    /// The file was written by this program: that is no edit.
    void wrote(const std::string& path, std::string text) { texts_[path] = std::move(text); }

    /// The texts as they were last seen, by path.
    const std::map<std::string, std::string>& texts() const { return texts_; }

    std::size_t size() const { return texts_.size(); }

private:
    void add(const SourceText& text);
    void add(const Place& place);

    Of of_;
    std::map<std::string, std::string> texts_;  // by path
};

}  // namespace crevice
