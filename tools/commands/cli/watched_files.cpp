// SPDX-License-Identifier: MIT
#include "tools/commands/cli/watched_files.h"

namespace crevice {

void WatchedFiles::add(const std::string& path)
{
    if (texts_.count(path) > 0) return;
    if (const SourceRef file = readFile(path)) texts_[path] = file->text;
}

void WatchedFiles::add(const SourceText& text)
{
    if (of_ == Of::all || text.path.empty()) add(text.name);
}

void WatchedFiles::add(const Place& place)
{
    if (place.source) add(*place.source);
}

void WatchedFiles::add(const Node& document)
{
    add(document.place);
    for (const Place& origin : document.origins) add(origin);
    for (const Node& item : document.items) add(item);
    for (const Member& member : document.members) {
        add(member.key_place);
        add(member.value);
    }
}

void WatchedFiles::add(const Description& description)
{
    for (const auto& file : description.files) add(*file.second);
}

void WatchedFiles::add(const Diagnostics& diagnostics)
{
    for (const Diagnostic& each : diagnostics) {
        add(each.place);
        for (const Note& note : each.notes) add(note.place);
    }
}

std::vector<std::string> WatchedFiles::changes()
{
    std::vector<std::string> paths;
    for (auto& [path, text] : texts_) {
        const SourceRef now = readFile(path);
        if (!now || now->text == text) continue;
        text = now->text;
        paths.push_back(path);
    }
    return paths;
}

}  // namespace crevice
