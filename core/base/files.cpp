// SPDX-License-Identifier: MIT
// Reading regular files, and telling where a path leads.
#include "core/base/files.h"

#include "core/base/text.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

namespace crevice {

namespace fs = std::filesystem;

namespace {

constexpr const char* kIrregular = "it is no regular file";

FileBytes failed(int error)
{
    if (error == ENOENT) return {{}, "it does not exist", true};
    if (error == ENXIO) return {{}, kIrregular};  // a socket
    return {{}, std::generic_category().message(error)};
}

// An open file, closed in the end.
class OpenFile {
public:
    // A pipe without a writer must not block, a terminal not become this process's own.
    explicit OpenFile(const std::string& path)
        : file_(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC))
    {
        struct stat info = {};
        if (file_ < 0 || fstat(file_, &info) != 0)
            opened_ = failed(errno);
        else if (S_ISDIR(info.st_mode))
            opened_.failure = "it is a folder";
        else if (!S_ISREG(info.st_mode))
            opened_.failure = kIrregular;
        else
            size = static_cast<std::uintmax_t>(info.st_size);
    }
    ~OpenFile()
    {
        if (file_ >= 0) close(file_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    // At most `count` bytes. The size is a hint: files of /proc have none.
    FileBytes read(std::size_t count) const
    {
        FileBytes result = opened_;
        if (!result) return result;
        result.bytes.reserve(static_cast<std::size_t>(std::min<std::uintmax_t>(size, count)));
        char buffer[1 << 14];
        while (result.bytes.size() < count) {
            const std::size_t wanted = std::min(sizeof(buffer), count - result.bytes.size());
            const ssize_t got = ::read(file_, buffer, wanted);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) return failed(errno);
            if (got == 0) break;
            result.bytes.append(buffer, static_cast<std::size_t>(got));
        }
        return result;
    }

    std::uintmax_t size = 0;

private:
    int file_;
    FileBytes opened_;
};

// Where a path leads. What cannot be resolved cannot be opened either.
fs::path resolved(const std::string& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    const fs::path canonical = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : canonical;
}

// Where `by` looks for the files that it names.
std::string folderOf(const SourceText& by)
{
    const fs::path folder = fs::path(locationOf(by)).parent_path();
    return folder.empty() ? "." : folder.string();
}

Diagnostic outside(const std::string& path, const std::vector<std::string>& folders)
{
    std::vector<std::string> shown;
    for (const std::string& folder : folders)
        shown.push_back("'" + resolved(folder).string() + "'");
    std::sort(shown.begin(), shown.end());
    shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
    Diagnostic error{Code::module_escape,
                     "the file '" + path + "' lies outside of " + joined(shown, " and ")};
    error.help =
        "a config reads files below its own folder alone; --root FOLDER, or LoadRequest::roots in "
        "a "
        "program, allows another folder";
    return error;
}

}  // namespace

FileBytes readBytes(const std::string& path, std::size_t limit)
{
    const OpenFile file(path);
    FileBytes result = file.size > limit ? FileBytes{} : file.read(limit + 1);
    if (file.size > limit || result.bytes.size() > limit)
        return {{}, "it has more than " + std::to_string(limit) + " bytes"};
    return result;
}

FileBytes readStart(const std::string& path, std::size_t count)
{
    return OpenFile(path).read(count);
}

bool isBelow(const std::string& path, const std::vector<std::string>& folders)
{
    if (path.find('\0') != std::string::npos)
        return false;  // the system would read less of it than is checked
    const fs::path file = resolved(path);
    return std::any_of(folders.begin(), folders.end(), [&file](const std::string& folder) {
        if (folder.empty()) return false;
        const fs::path below = file.lexically_relative(resolved(folder));
        return !below.empty() && *below.begin() != "..";
    });
}

Result<SourceRef> openNamed(const SourceText& by, const std::string& path)
{
    const std::vector<std::string> folders =
        by.roots ? *by.roots : std::vector<std::string>{folderOf(by)};
    if (!isBelow(path, folders)) return outside(path, folders);
    return readFile(path, by.roots);
}

}  // namespace crevice
