// SPDX-License-Identifier: MIT
// Cursors into a document, and errors put into its order.
#include "core/config/decode_report.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/json/override.h"

#include <algorithm>

namespace crevice::table {

namespace {

std::vector<Note> notesOf(const std::vector<Place>& origins)
{
    std::vector<Note> notes;
    for (const Place& origin : origins) notes.push_back({origin, "the base value was set here"});
    return notes;
}

// The child of that key, or of that index where the parent is a list.
const Node* childAt(const Node& parent, const std::string& key, std::size_t& index)
{
    for (index = 0; index < parent.members.size(); ++index)
        if (parent.members[index].key == key) return &parent.members[index].value;
    for (index = 0; index < parent.items.size(); ++index)
        if (std::to_string(index) == key) return &parent.items[index];
    return nullptr;
}

bool isWithin(std::string_view pointer, std::string_view outer)
{
    return startsWith(pointer, outer) &&
           (pointer.size() == outer.size() || pointer[outer.size()] == '/');
}

}  // namespace

Cursor Cursor::child(const Member& member) const
{
    return {member.value,
            memberPointer(pointer, member.key),
            member.key_place,
            member.key,
            key.empty() ? member.key : key + " " + member.key,
            doc};
}

Cursor Cursor::item(std::size_t index) const
{
    return {node.items[index], pointer + "/" + std::to_string(index), key_place, key, label, doc};
}

bool Report::leavesOut(const Place& key) const
{
    return document_.origins.size() > 1 && !(key.source && key.source->path == kOverridePath);
}

std::string Report::otherSection(const std::string& section, const std::string& name) const
{
    for (const std::string other : {"params", "features"}) {
        const Node* entries = other == section ? nullptr : document_.find(other);
        const Node* declared = entries ? entries->find(name) : nullptr;
        if (declared && declared->kind == Node::Kind::object)
            return "'" + name + "' is a " + other.substr(0, other.size() - 1) +
                   ": write it under " + other;
    }
    return {};
}

void Report::leaveOut(Diagnostic& error)
{
    error.severity = Severity::warning;
    error.help = "it is left out: what declares it is not part of this config";
}

Reported& Report::atValue(const Cursor& cursor, Code code, std::string message, std::string help)
{
    return add({code, std::move(message), help.empty() ? cursor.doc : std::move(help),
                cursor.node.place, cursor.pointer, notesOf(cursor.node.origins)});
}

Reported& Report::atKey(const Cursor& cursor, Code code, std::string message, std::string help)
{
    return add({code, std::move(message), help.empty() ? cursor.doc : std::move(help),
                cursor.key_place, cursor.pointer});
}

Reported& Report::at(const Reference& reference, Code code, std::string message, std::string help)
{
    return add({code, std::move(message), std::move(help), reference.place, reference.pointer,
                notesOf(reference.origins)});
}

Reported& Report::add(Diagnostic diagnostic)
{
    if (errors_.size() == kMaxDiagnostics) {
        if (errors_.back().severity == Severity::error) dropped_ = std::move(errors_.back());
        errors_.pop_back();
        ++more_;
    }
    errors_.push_back({std::move(diagnostic)});
    return errors_.back();
}

bool Report::errorAt(std::string_view pointer) const
{
    return std::any_of(errors_.begin(), errors_.end(),
                       [&](const Reported& each) { return each.pointer == pointer; });
}

bool Report::errorWithin(std::string_view pointer) const
{
    return std::any_of(errors_.begin(), errors_.end(),
                       [&](const Reported& each) { return isWithin(each.pointer, pointer); });
}

Diagnostics Report::take(const Node& document)
{
    if (dropped_) errors_.push_back(*std::move(dropped_));
    dropped_.reset();
    using Ordered = std::pair<std::vector<std::size_t>, Reported>;
    std::vector<Ordered> ordered;
    for (Reported& each : errors_)
        ordered.emplace_back(locate(document, each.pointer).path, std::move(each));
    errors_.clear();
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Ordered& a, const Ordered& b) { return a.first < b.first; });

    Diagnostics diagnostics;
    std::map<std::string, std::size_t> reported;  // mistakes, and their diagnostics
    for (auto& [path, error] : ordered) {
        const auto [first, fresh] = reported.emplace(error.mistake, diagnostics.size());
        if (!fresh && !error.mistake.empty()) {
            diagnostics[first->second].notes.push_back({error.place, "and here"});
            continue;
        }
        if (error.cause.source) blame(error, error.cause, "it is named here");
        diagnostics.push_back(std::move(error));
    }
    if (more_ > 0) diagnostics.back().notes.push_back(moreNote(std::size_t(more_)));
    return diagnostics;
}

Located locate(const Node& document, std::string_view pointer)
{
    Located located = {&document};
    for (const std::string& key : pointerKeys(pointer)) {
        if (!located.node) break;
        located.path.push_back(0);
        located.node = childAt(*located.node, key, located.path.back());
    }
    return located;
}

Reference referenceAt(const Node& document, const std::string& pointer)
{
    const Node& node = *locate(document, pointer).node;
    return {node.text, node.place, pointer, node.origins};
}

bool isExtension(std::string_view key) { return key.substr(0, 2) == "x-"; }

std::string numberText(double number) { return significant(number, 10); }

}  // namespace crevice::table
