// SPDX-License-Identifier: MIT
// The files that a config was read from, watched for edits.
#pragma once

#include <crevice/config.h>
#include <crevice/diagnostic.h>

#include <map>
#include <string>

namespace crevice {

/// Finds edits by reading the files again: small ones, a few times a second. That needs no service
/// of the system's, works on every file system, and is not deceived by editors that write a new
/// file and rename it, or that save what was there before.
class WatchedFiles {
public:
    /// Adds a file by its path.
    void add(const std::string& path);

    /// Adds every file on disk that has a part in the document, the description or the errors.
    void add(const Node& document);
    void add(const Description& description);
    void add(const Diagnostics& diagnostics);

    /// Whether any of them differs from when this was last asked, or from when it was added. A file
    /// that cannot be read just now has not changed.
    bool changed();

    std::size_t size() const { return texts_.size(); }

private:
    void add(const Place& place);

    std::map<std::string, std::string> texts_;  // by path
};

}  // namespace crevice
