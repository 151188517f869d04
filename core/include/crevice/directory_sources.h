// SPDX-License-Identifier: MIT
// Modules and configs in a folder.
#pragma once

#include <crevice/source.h>

#include <string>
#include <vector>

namespace crevice {

/// Files below a folder, read again at each `find`: what --effects reads. A link that leads out of
/// the folder and of `roots` is no text.
class DirectorySources : public SourceSet {
public:
    explicit DirectorySources(std::string root, std::vector<std::string> roots = {})
        : root_(std::move(root)),
          roots_(std::move(roots))
    {
        roots_.push_back(root_);
    }

    SourceRef find(std::string_view path) const override;
    std::vector<std::string> list() const override;

private:
    std::string root_;
    std::vector<std::string> roots_;  // with root_
};

}  // namespace crevice
