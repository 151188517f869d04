// SPDX-License-Identifier: MIT
// "radius=0.8" as a patch.
#include "core/json/override.h"

#include "core/base/text.h"
#include "core/json/merge.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace crevice {

namespace {

// The keys on the way to what an override sets.
Result<std::vector<std::string>> overrideKeys(const Node& document, const std::string& name,
                                              const Place& place)
{
    if (name[0] == '/') return pointerKeys(name);
    std::vector<std::string> names;
    for (const char* section : {"params", "features"}) {
        const Node* entries = document.find(section);
        if (!entries) continue;
        // A bare value that no object has been laid under declares nothing.
        const Node* declared = entries->find(name);
        if (declared && declared->kind == Node::Kind::object)
            return std::vector<std::string>{section, name, "default"};
        for (const Member& member : entries->members) names.push_back(member.key);
    }
    return Diagnostic{Code::unknown_param, "'" + name + "' is neither a param nor a feature",
                      suggestName(name, std::move(names), "params and features"), place};
}

// Makes the patch that sets what stands at the keys. A list is patched as a whole, so on the way
// through one its other items are copied.
struct PatchMaker {
    const std::vector<std::string>& keys;
    const Place& place;
    Diagnostics& errors;

    // The patch of `base`, which is null where nothing is yet, by the keys from `at` on.
    Node patch(const Node* base, std::size_t at, Node value)
    {
        if (at == keys.size()) return value;
        if (base && base->kind == Node::Kind::array) return listWith(*base, at, std::move(value));
        Node object;
        object.kind = Node::Kind::object;
        object.place = place;
        Node below = patch(base ? base->find(keys[at]) : nullptr, at + 1, std::move(value));
        object.members.push_back({keys[at], place, std::move(below)});
        return object;
    }

    Node listWith(Node list, std::size_t at, Node value)
    {
        std::vector<Node>& items = list.items;
        std::size_t index = 0;
        const char* const end = keys[at].data() + keys[at].size();
        const auto read = std::from_chars(keys[at].data(), end, index);
        if (read.ec != std::errc() || read.ptr != end || index > items.size()) {
            noItem(items.size(), at);
            return list;
        }
        list.place = place;
        const auto item = items.begin() + static_cast<std::ptrdiff_t>(index);
        const bool there = index < items.size();
        Node changed = patch(there ? &*item : nullptr, at + 1, std::move(value));
        if (!there)
            items.push_back(std::move(changed));
        else if (changed.kind == Node::Kind::null)
            items.erase(item);
        else if (at + 1 == keys.size())
            *item = std::move(changed);
        else
            mergePatch(*item, changed, errors);
        return list;
    }

    void noItem(std::size_t count, std::size_t at)
    {
        std::string pointer;
        for (std::size_t i = 0; i <= at; ++i) pointer = memberPointer(pointer, keys[i]);
        Diagnostic error{Code::merge_missing,
                         "found no item '" + keys[at] + "' in a list of " + std::to_string(count),
                         "", place, std::move(pointer)};
        error.help = count == 0 ? "write 0 to add an item"
                                : "items are counted from 0 to " + std::to_string(count - 1) +
                                      "; write " + std::to_string(count) + " to add one";
        errors.push_back(std::move(error));
    }
};

}  // namespace

Result<Override> readOverride(const std::string& text, const std::vector<std::string>& roots)
{
    const std::size_t equals = text.find('=');
    std::vector<std::string> folders = roots;
    folders.push_back(".");  // where its files stand
    const auto source = std::make_shared<SourceText>(
        SourceText{"--set " + text,
                   text,
                   kOverridePath,
                   {},
                   std::make_shared<const std::vector<std::string>>(std::move(folders))});
    const Place place{source, 1, 1, static_cast<int>(std::min(equals, text.size()))};
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        return Diagnostic{Code::override_syntax, "found '" + text + "' where name=value was wanted",
                          "write radius=0.8, or /passes/blur/when=null for any place", place};

    // The name is blank while the value is read, so that columns count from the override's start.
    source->text = std::string(equals + 1, ' ') + text.substr(equals + 1);
    Result<Node> value = parseValue(source);
    source->text = text;
    if (!value) return value.diagnostics();
    return Override{text.substr(0, equals), place, std::move(*value)};
}

Status applyOverride(Node& document, const std::string& text, const std::vector<std::string>& roots)
{
    Result<Override> read = readOverride(text, roots);
    if (!read) return read.diagnostics();
    const Result<std::vector<std::string>> keys = overrideKeys(document, read->name, read->place);
    if (!keys) return keys.diagnostics();
    Diagnostics errors;
    const Node patch =
        PatchMaker{*keys, read->place, errors}.patch(&document, 0, std::move(read->value));
    if (errors.empty()) mergePatch(document, patch, errors);
    return errors;
}

}  // namespace crevice
