// SPDX-License-Identifier: MIT
// The sets of texts: in memory, in a folder, in layers; and paths between them.
#include <crevice/source.h>

#include "core/base/files.h"
#include "core/base/text.h"

#include <algorithm>
#include <filesystem>
#include <set>

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

SourceRef LayeredSources::find(std::string_view path) const
{
    for (const SourceSet* layer : layers_)
        if (SourceRef source = layer->find(path)) return source;
    return nullptr;
}

std::vector<std::string> LayeredSources::list() const
{
    std::set<std::string> paths;
    for (const SourceSet* layer : layers_)
        for (std::string& path : layer->list()) paths.insert(std::move(path));
    return {paths.begin(), paths.end()};
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

}  // namespace crevice
