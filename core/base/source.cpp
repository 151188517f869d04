// SPDX-License-Identifier: MIT
// The sets of texts in memory and in layers, and whose a place is.
#include <crevice/source.h>

#include <set>

namespace crevice {

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

}  // namespace crevice
