// SPDX-License-Identifier: MIT
// The texts of the page: shipped modules and configs, and over them what the user edited.
#pragma once

#include <crevice/source.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace crevice::page {

class Texts {
public:
    Texts();

    const SourceSet& sources() const { return all_; }

    /// Puts a text over the shipped one of that path, or beside the shipped ones.
    void set(const std::string& path, std::string text) { edits_.add(path, std::move(text)); }

    /// Takes it away again.
    void reset(const std::string& path);

    /// Paths whose text is not the shipped one, sorted.
    std::vector<std::string> edited() const;

    /// [{"name", "description"}] of all configs; the description is empty where it cannot be read.
    nlohmann::json configs() const;

private:
    MemorySources edits_;
    LayeredSources all_;
};

}  // namespace crevice::page
