// SPDX-License-Identifier: MIT
// Where text comes from: a named text, a place in it, and the sets of texts that modules live in.
//
// Every value keeps the place it was written at, so that messages point at it whatever was merged.
#pragma once

#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace crevice {

/// The largest config or GLSL file that is read.
constexpr std::size_t kMaxDocumentBytes = 1u << 20;

struct Place;

/// Folders on disk below which a text may name files; null for its own folder.
using SourceRoots = std::shared_ptr<const std::vector<std::string>>;

/// One text and the name a user knows it by: a path on disk, or a path inside the catalog.
struct SourceText {
    std::string name;
    std::string text;
    std::string path = {};  ///< Its path in the SourceSet it came from; empty for a file on disk.
    std::shared_ptr<const Place> asked = {};  ///< The entry of `extends` that brought it, or null.
    SourceRoots roots = {};  ///< Of a file on disk: below which it may name others.
};

using SourceRef = std::shared_ptr<const SourceText>;

/// A stretch of a text. Lines and columns count from 1, columns in bytes; line 0 means "nowhere".
struct Place {
    SourceRef source;  ///< Null when the value was not read from a text.
    int line = 0;
    int column = 0;
    int length = 1;  ///< Bytes to underline, at least 1.
};

/// True in a module that some file's `extends` brought.
bool isModule(const Place& place);

/// The place itself where it is in the config or in a file on disk; for one in a module, the entry
/// of `extends` in such a file that brought the module.
Place ownPlace(const Place& place);

/// Texts by path: "ssao/hemisphere.json", "ssao/shaders/hemisphere.frag",
/// "configs/learnopengl.json". Paths use '/', have no leading slash and no "..".
class SourceSet {
public:
    virtual ~SourceSet() = default;

    /// The text at `path`, or null when there is none.
    virtual SourceRef find(std::string_view path) const = 0;

    /// All paths, sorted.
    virtual std::vector<std::string> list() const = 0;
};

/// Texts held in memory; what tests and the embedded catalog use.
class MemorySources : public SourceSet {
public:
    /// Adds or replaces the text at `path`. A message names it `name`, or `path` if that is empty.
    void add(std::string path, std::string text, std::string name = {});

    SourceRef find(std::string_view path) const override;
    std::vector<std::string> list() const override;

private:
    std::map<std::string, SourceRef, std::less<>> texts_;  // by path
};

/// Files below a folder, read at each `find` (--effects). A link out of it and `roots` is no text.
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

/// Several sets seen as one; an earlier set hides a later one. The sets must outlive this.
class LayeredSources : public SourceSet {
public:
    explicit LayeredSources(std::vector<const SourceSet*> layers) : layers_(std::move(layers)) {}

    SourceRef find(std::string_view path) const override;
    std::vector<std::string> list() const override;

private:
    std::vector<const SourceSet*> layers_;
};

/// True for a path that begins with "./" or "../".
bool isRelative(std::string_view path);

/// True for a path on disk, one that begins with '/', "./" or "../": none in a SourceSet does.
bool isOnDisk(std::string_view path);

/// `path` seen from the folder of `from`: ("configs/a.json", "./b.frag") gives "configs/b.frag".
/// A path that is not relative is returned as it is. Empty when it would climb
/// above the root of a catalog path; a path on disk may climb as far as it likes.
std::string resolvePath(std::string_view from, std::string_view path);

/// Where a text is, to resolve paths against: its path in a SourceSet, or one that isOnDisk.
std::string locationOf(const SourceText& source);

/// Reads a regular file, cut one byte behind kMaxDocumentBytes. Null when it cannot be read.
SourceRef readFile(const std::string& path, SourceRoots roots = {});

/// Anything a config names. `pointer` is its RFC 6901 pointer in the merged document.
struct Named {
    std::string name;
    Place place = {};
    std::string pointer = {};
};

/// The element of that name in a vector or array, or null.
template <class List>
auto findNamed(const List& list, std::string_view name) -> decltype(std::data(list))
{
    for (const auto& element : list)
        if (element.name == name) return &element;
    return nullptr;
}

/// The index of that name in a vector or array, or -1.
template <class List>
int indexOf(const List& list, std::string_view name)
{
    const auto* element = findNamed(list, name);
    return element ? static_cast<int>(element - std::data(list)) : -1;
}

/// All names of a list.
template <class List>
std::vector<std::string> namesOf(const List& list)
{
    std::vector<std::string> names;
    for (const auto& element : list) names.push_back(element.name);
    return names;
}

}  // namespace crevice
