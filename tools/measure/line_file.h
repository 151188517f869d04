// SPDX-License-Identifier: MIT
// A file of results that grows line by line and loses none of them, whatever stops the run.
#pragma once

#include <crevice/diagnostic.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>

namespace crevice {

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

    /// Adds a whole line, or nothing. Errors: CV7007.
    Status append(const std::string& line);

    const std::string& path() const { return path_; }

    /// What to do about a CV7007 in the middle of a run.
    static const char* wayOut();

private:
    LineFile(std::string path, int file) : path_(std::move(path)), file_(file) {}

    std::string path_;
    int file_ = -1;
};

/// JSON as one line of a file. Text that is no UTF-8 is replaced where it is wrong, which is better
/// than a lost line.
std::string jsonLine(const nlohmann::json& json);

/// What messages call the lines of a file.
struct LineKind {
    const char* name;     ///< "bench sample".
    const char* command;  ///< That writes them: "crevice bench".
};

/// Has each line of the file taken, as JSON. `take` may throw what nlohmann::json throws. A line
/// that an interrupt cut short is left out with a warning.
///
/// Errors: CV7009 for a file that cannot be read or a line that is not of the kind.
Diagnostics readLines(const std::string& path, const LineKind& kind,
                      const std::function<void(nlohmann::json&&)>& take);

/// The first that is an error; `diagnostics` has one.
inline const Diagnostic& firstError(const Diagnostics& diagnostics)
{
    const auto isError = [](const Diagnostic& each) { return each.severity == Severity::error; };
    return *std::find_if(diagnostics.begin(), diagnostics.end(), isError);
}

/// "my.frag:12:3: CV5001: the message; the help": the first error, as a line has it.
std::string failureText(const Diagnostics& diagnostics);

}  // namespace crevice
