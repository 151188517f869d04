// SPDX-License-Identifier: MIT
// Folders of texts, paths between texts, and regular files.
#include <crevice/source.h>

#include "core/base/files.h"
#include "core/base/text.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace crevice {

namespace fs = std::filesystem;

namespace {

// True for a path as SourceSet promises it: no root, no empty part, no "." and no "..".
bool isInside(std::string_view path)
{
    for (const std::string_view part : split(path, '/'))
        if (part.empty() || part == "." || part == "..") return false;
    return true;
}

// Where a path leads. What cannot be resolved cannot be opened either.
fs::path resolved(const std::string& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    const fs::path canonical = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : canonical;
}

std::string folderOf(const std::string& path)
{
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

Diagnostic outside(const std::string& path, const std::vector<std::string>& folders)
{
    std::set<std::string> shown;
    for (const std::string& folder : folders) shown.insert("'" + resolved(folder).string() + "'");
    return {
        Code::module_escape,
        "the file '" + path + "' lies outside of " + joined({shown.begin(), shown.end()}, " and "),
        "a config reads files below its own folder alone; --root FOLDER, or LoadRequest::roots "
        "in a program, allows another folder"};
}

}  // namespace

bool isRelative(std::string_view path) { return startsWith(path, "./") || startsWith(path, "../"); }

bool isOnDisk(std::string_view path) { return startsWith(path, "/") || isRelative(path); }

std::string resolvePath(std::string_view from, std::string_view path)
{
    if (!isRelative(path)) return std::string(path);
    const fs::path folder = fs::path(from).parent_path();
    const std::string whole = (folder / path).lexically_normal().generic_string();
    if (isOnDisk(from)) return isOnDisk(whole) ? whole : "./" + whole;
    return isRelative(whole + '/') ? "" : whole;
}

std::string locationOf(const SourceText& source)
{
    if (!source.path.empty()) return source.path;
    return isOnDisk(source.name) ? source.name : "./" + source.name;
}

SourceRef readFile(const std::string& path, SourceRoots roots)
{
    FileBytes file = readStart(path, kMaxDocumentBytes + 1);
    if (!file) return nullptr;
    return std::make_shared<const SourceText>(
        SourceText{path, std::move(file.bytes), {}, {}, std::move(roots)});
}

SourceRef DirectorySources::find(std::string_view path) const
{
    const std::string file = root_ + '/' + std::string(path);
    if (!isInside(path) || !isBelow(file, roots_)) return nullptr;
    const SourceRef found = readFile(file);
    if (!found) return nullptr;
    SourceText text = *found;
    text.path = path;
    return std::make_shared<const SourceText>(std::move(text));
}

std::vector<std::string> DirectorySources::list() const
{
    // What it may hold beside modules (pictures, editors' backups) is none of a catalog's texts.
    std::vector<std::string> paths =
        filesBelow(root_, {".json", ".glsl", ".vert", ".frag", ".comp"});
    std::sort(paths.begin(), paths.end());
    return paths;
}

FileBytes readBytes(const std::string& path, std::size_t limit)
{
    std::error_code unknown;  // no regular file, or none: readStart says which
    const std::uintmax_t size = fs::file_size(path, unknown);
    if (unknown || size <= limit) {  // files of /proc have the size 0
        FileBytes result = readStart(path, limit + 1);
        if (result.bytes.size() <= limit) return result;
    }
    return {{}, "it has more than " + std::to_string(limit) + " bytes"};
}

FileBytes readStart(const std::string& path, std::size_t count)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) return {{}, "it does not exist", true};
    if (!fs::status_known(status)) return {{}, error.message()};
    if (fs::is_directory(status)) return {{}, "it is a folder"};
    if (!fs::is_regular_file(status)) return {{}, "it is no regular file"};
    std::ifstream file(path, std::ios::binary);
    if (!file) return {{}, std::generic_category().message(errno)};
    FileBytes result;
    char buffer[1 << 14];
    while (file && result.bytes.size() < count) {
        file.read(buffer, std::min(sizeof(buffer), count - result.bytes.size()));
        result.bytes.append(buffer, static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) result.failure = std::generic_category().message(errno);
    return result;
}

std::string absenceOf(const std::string& path)
{
    const FileBytes file = readStart(path, 0);
    return file.missing ? "does not exist" : "cannot be read: " + file.failure;
}

std::vector<std::string> filesBelow(const std::string& folder,
                                    const std::vector<std::string_view>& endings, int depth,
                                    int most)
{
    std::vector<std::string> files;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    fs::recursive_directory_iterator at(folder, options, error);
    for (int seen = 0; !error && at != fs::end(at) && seen < most; ++seen) {
        if (at.depth() == depth) at.disable_recursion_pending();
        const std::string path = at->path().lexically_relative(folder).generic_string();
        const auto ends = [&path](std::string_view ending) { return endsWith(path, ending); };
        std::error_code unreadable;  // an entry that cannot be looked at is left out
        if (anyOf(endings, ends) && at->is_regular_file(unreadable)) files.push_back(path);
        at.increment(error);
    }
    return files;
}

std::vector<std::string> filesBeside(const std::string& path, const std::string& written,
                                     std::string_view ending)
{
    constexpr int kMaxSeen = 4096;  // a home folder may hold millions
    std::vector<std::string> files = filesBelow(folderOf(path), {ending}, 1, kMaxSeen);
    for (std::string& each : files) each = (fs::path(written).parent_path() / each).string();
    return files;
}

bool isBelow(const std::string& path, const std::vector<std::string>& folders)
{
    if (has(path, {"\0", 1})) return false;  // the system would read less of it than is checked
    const fs::path file = resolved(path);
    return anyOf(folders, [&file](const std::string& folder) {
        if (folder.empty()) return false;
        const fs::path below = file.lexically_relative(resolved(folder));
        return !below.empty() && *below.begin() != "..";
    });
}

std::string slashed(const SourceText& by, std::string_view name)
{
    std::string path;
    for (const char c : name) {
        const std::size_t letter = std::string_view("\b\f\n\r\t").find(c);
        const bool escape = letter != std::string_view::npos;
        path += escape || c == '\\' ? '/' : c;
        if (escape) path += "bfnrt"[letter];
    }
    if (path == name) return {};
    if (!isOnDisk(path)) path = "./" + path;
    const Result<SourceRef> found = openNamed(by, resolvePath(locationOf(by), path));
    return "paths have '/'" + (found && *found ? ": write '" + path + "'" : "");
}

Status mayName(const SourceText& by, const std::string& path)
{
    const std::vector<std::string> folders =
        by.roots ? *by.roots : std::vector<std::string>{folderOf(locationOf(by))};
    if (!isBelow(path, folders)) return outside(path, folders);
    return {};
}

Result<SourceRef> openNamed(const SourceText& by, const std::string& path)
{
    if (const Status allowed = mayName(by, path); !allowed) return allowed.diagnostics();
    return readFile(path, by.roots);
}

}  // namespace crevice
