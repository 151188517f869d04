// SPDX-License-Identifier: MIT
// The sets of texts: in memory, in a folder, in layers; and paths between them.
#include <crevice/source.h>

#include "core/base/files.h"
#include "core/base/text.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
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

// What a folder may hold beside modules (pictures, editors' backups) is none of a catalog's texts.
bool isText(const fs::path& path)
{
    const fs::path extension = path.extension();
    for (const char* known : {".json", ".glsl", ".vert", ".frag", ".comp"})
        if (extension == known) return true;
    return false;
}

std::shared_ptr<SourceText> readText(const std::string& path)
{
    FileBytes file = readStart(path, kMaxDocumentBytes + 1);
    if (!file) return nullptr;
    auto source = std::make_shared<SourceText>();
    source->name = path;
    source->text = std::move(file.bytes);
    return source;
}

}  // namespace

void MemorySources::add(std::string path, std::string text, std::string name)
{
    if (name.empty()) name = path;
    texts_[path] = std::make_shared<SourceText>(SourceText{std::move(name), std::move(text), path});
}

SourceRef MemorySources::find(std::string_view path) const
{
    const auto at = texts_.find(path);
    return at != texts_.end() ? at->second : nullptr;
}

std::vector<std::string> MemorySources::list() const
{
    std::vector<std::string> paths;
    for (const auto& entry : texts_) paths.push_back(entry.first);
    return paths;
}

SourceRef DirectorySources::find(std::string_view path) const
{
    const std::string file = root_ + '/' + std::string(path);
    if (!isInside(path) || !isBelow(file, roots_)) return nullptr;
    const auto source = readText(file);
    if (source) source->path = path;
    return source;
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

SourceRef LayeredSources::find(std::string_view path) const
{
    for (const SourceSet* layer : layers_)
        if (SourceRef source = layer->find(path)) return source;
    return nullptr;
}

std::vector<std::string> LayeredSources::list() const
{
    std::vector<std::string> paths;
    for (const SourceSet* layer : layers_) {
        std::vector<std::string> more = layer->list();
        std::move(more.begin(), more.end(), std::back_inserter(paths));
    }
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

bool isModule(const Place& place)
{
    return place.source && place.source->asked && !place.source->path.empty();
}

Place ownPlace(const Place& place)
{
    const Place* at = &place;
    while (isModule(*at)) at = at->source->asked.get();
    return *at;
}

bool isRelative(std::string_view path) { return startsWith(path, "./") || startsWith(path, "../"); }

bool isOnDisk(std::string_view path) { return startsWith(path, "/") || isRelative(path); }

std::string resolvePath(std::string_view from, std::string_view path)
{
    if (!isRelative(path)) return std::string(path);
    std::vector<std::string_view> parts = split(from, '/');
    parts.pop_back();
    for (const std::string_view part : split(path, '/')) {
        if (part == "." || part.empty()) continue;
        const bool climbs = part == "..";
        const bool at_root =
            parts.empty() || parts.back().empty() || parts.back() == "." || parts.back() == "..";
        if (!climbs)
            parts.push_back(part);
        else if (!at_root)
            parts.pop_back();
        else if (!isOnDisk(from))
            return {};
        else
            parts.push_back(part);
    }
    std::string whole(parts.empty() ? "" : parts.front());
    for (std::size_t i = 1; i < parts.size(); ++i) whole.append("/").append(parts[i]);
    return whole;
}

std::string locationOf(const SourceText& source)
{
    if (!source.path.empty()) return source.path;
    return isOnDisk(source.name) ? source.name : "./" + source.name;
}

SourceRef readFile(const std::string& path, SourceRoots roots)
{
    const auto source = readText(path);
    if (source) source->roots = std::move(roots);
    return source;
}

}  // namespace crevice
