// SPDX-License-Identifier: MIT
// Appending lines to a file that nobody else writes, and reading them.
#include "tools/measure/line_file.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/image/image_file.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace crevice {
namespace {

/// Most bytes of results that are read: a hundred thousand lines and more.
constexpr std::size_t kMaxResultBytes = 256u << 20;

const char* const kWayOut =
    "what was measured before is safe; make room or name another folder, and run the same command "
    "again to go on";

Diagnostic cannotRecord(const std::string& path, const std::string& reason)
{
    return {Code::cannot_write, "cannot write '" + path + "': " + reason, kWayOut};
}

/// Cuts off what follows the last line feed. Zero, or the errno of what failed.
int cutTornLine(int file)
{
    off_t end = lseek(file, 0, SEEK_END);
    char last = '\n';
    while (end > 0 && pread(file, &last, 1, end - 1) == 1 && last != '\n') --end;
    return ftruncate(file, end) == 0 ? 0 : errno;
}

/// Zero, or the errno of what failed.
int writeToDisk(int file, std::string_view bytes)
{
    if (const int failure = writeAll(file, bytes)) return failure;
    return fdatasync(file) == 0 || errno == EINVAL ? 0 : errno;
}

/// An interrupt leaves the beginning of a line and no end.
bool isCutShort(const std::string& line) { return line.front() == '{' && line.back() != '}'; }

constexpr std::size_t kExcerpt = 72;

Diagnostic lineDiagnostic(const std::string& path, int number, const std::string& line,
                          const LineKind& kind, const std::string& reason)
{
    Diagnostic diagnostic{Code::results_broken,
                          "this line is not a " + std::string(kind.name) + ": " + reason};
    // The message shows the line's beginning; a whole line would fill the screen.
    const std::string excerpt =
        std::string(static_cast<std::size_t>(number - 1), '\n') + line.substr(0, kExcerpt);
    diagnostic.place = {std::make_shared<SourceText>(SourceText{path, excerpt}), number, 1, 1};
    diagnostic.help = "delete the line; '" + std::string(kind.command) + "' measures it again";
    return diagnostic;
}

/// Without the library's own prefix, "[json.exception.type_error.302] ".
std::string reasonOf(const nlohmann::json::exception& error)
{
    const std::string text = error.what();
    const std::size_t end = text.find("] ");
    return end == std::string::npos ? text : text.substr(end + 2);
}

}  // namespace

Result<LineFile> LineFile::open(const std::string& path)
{
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    std::error_code error;
    if (!folder.empty()) std::filesystem::create_directories(folder, error);
    if (error) return cannotRecord(folder.string(), error.message());
    constexpr int kFlags = O_RDWR | O_CREAT | O_APPEND | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    LineFile lines(path, ::open(path.c_str(), kFlags, 0666));
    struct stat info = {};
    if (lines.file_ < 0 || fstat(lines.file_, &info) != 0)
        return cannotRecord(path, std::strerror(errno));
    if (!S_ISREG(info.st_mode)) return cannotRecord(path, "it is no regular file");
    if (flock(lines.file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return cannotRecord(path, "another run is writing to it");
    if (const int failure = cutTornLine(lines.file_))
        return cannotRecord(path, std::strerror(failure));
    return lines;
}

LineFile::~LineFile()
{
    if (file_ >= 0) close(file_);
}

LineFile::LineFile(LineFile&& other) noexcept
    : path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1))
{
}

Status LineFile::append(const std::string& line)
{
    const off_t before = lseek(file_, 0, SEEK_END);
    const int failure = writeToDisk(file_, line + "\n");
    if (failure == 0) return {};
    // Where even this fails, the next run cuts the torn line off.
    if (ftruncate(file_, before) != 0) return cannotRecord(path_, "the disk fails");
    return cannotRecord(path_, std::strerror(failure));
}

const char* LineFile::wayOut() { return kWayOut; }

std::string jsonLine(const nlohmann::json& json)
{
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Diagnostics readLines(const std::string& path, const LineKind& kind,
                      const std::function<void(nlohmann::json&&)>& take)
{
    FileBytes file = readBytes(path, kMaxResultBytes);
    if (!file.bytes.empty() && file.bytes[0] != '{' && !has(file.bytes, "\n{"))
        file.failure = "none of its lines begins with '{'";
    if (!file) {
        return {{Code::results_broken,
                 "no results can be read from '" + path + "': " + file.failure,
                 "'" + std::string(kind.command) + "' writes them: " + kind.command + " --help"}};
    }
    Diagnostics diagnostics;
    int number = 0;
    for (const std::string_view text : split(file.bytes, '\n')) {
        std::string line(text);
        ++number;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty()) continue;
        try {
            take(nlohmann::json::parse(line));
        } catch (const nlohmann::json::exception& error) {
            const bool cut = isCutShort(line);
            diagnostics.push_back(lineDiagnostic(path, number, line, kind,
                                                 cut ? "it was cut short" : reasonOf(error)));
            if (cut) diagnostics.back().severity = Severity::warning;
        }
    }
    return diagnostics;
}

std::string failureText(const Diagnostics& diagnostics)
{
    const Diagnostic& error = firstError(diagnostics);
    const std::string place = placeName(error.place);
    return (place.empty() ? "" : place + ": ") + codeName(error.code) + ": " + error.message +
           (error.help.empty() ? "" : "; " + error.help);
}

}  // namespace crevice
