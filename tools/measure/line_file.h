// SPDX-License-Identifier: MIT
// A file of results that grows line by line and loses none of them, whatever stops the run.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>

namespace crevice {

/// Most bytes of results that are read: a hundred thousand lines and more.
constexpr std::size_t kMaxResultBytes = 256u << 20;

class LineFile {
public:
    /// Makes the file and its folder where they are not there, and cuts off a last line that an
    /// interrupt left unfinished. Keeps others out until it is destroyed.
    ///
    /// Errors: CV7007 when it cannot be written or another run is at it.
    static Result<LineFile> open(const std::string& path);
    ~LineFile();
    LineFile(LineFile&& other) noexcept;
    LineFile(const LineFile&) = delete;
    LineFile& operator=(const LineFile&) = delete;

    /// Adds a whole line, or nothing. Errors: CV7007, also when the file is no longer there.
    Status append(const std::string& line);

    const std::string& path() const { return path_; }

    /// What to do about a CV7007 in the middle of a run.
    static const char* wayOut();

private:
    LineFile(std::string path, int file) : path_(std::move(path)), file_(file) {}

    std::string path_;
    int file_ = -1;
};

}  // namespace crevice
