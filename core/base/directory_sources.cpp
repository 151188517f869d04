// SPDX-License-Identifier: MIT
// A folder as a set of texts.
#include <crevice/source.h>

#include "core/base/files.h"
#include "core/base/text.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace crevice {

namespace fs = std::filesystem;

namespace {

/// True for a path as SourceSet promises it: no root, no empty part, no "." and no "..".
bool isInside(std::string_view path)
{
    for (const std::string_view part : split(path, '/'))
        if (part.empty() || part == "." || part == "..") return false;
    return true;
}

/// What a folder may hold beside modules (pictures, editors' backups) is none of a catalog's texts.
bool isText(const fs::path& path)
{
    const fs::path extension = path.extension();
    for (const char* known : {".json", ".glsl", ".vert", ".frag", ".comp"})
        if (extension == known) return true;
    return false;
}

}  // namespace

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
    std::vector<std::string> paths;
    std::error_code error;
    const auto options = fs::directory_options::skip_permission_denied;
    fs::recursive_directory_iterator at(root_, options, error);
    while (!error && at != fs::recursive_directory_iterator()) {
        std::error_code unreadable;  // an entry that cannot be looked at is left out
        if (isText(at->path()) && at->is_regular_file(unreadable))
            paths.push_back(at->path().lexically_relative(root_).generic_string());
        at.increment(error);
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace crevice
