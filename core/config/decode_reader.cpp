// SPDX-License-Identifier: MIT
// What the decoding visitor does with keys: missing, unknown, refused, badly named.
#include "core/config/decode_reader.h"
#include "core/config/decode_steps.h"

#include "core/base/text.h"

#include <algorithm>

namespace crevice::table {

namespace {

// One GLSL line holds it with room to spare, and the shortest limit among drivers is far longer.
constexpr std::size_t kMaxNameBytes = 64;

const std::vector<std::string> kSections = {"params",  "features", "imports",    "generated",
                                            "targets", "shaders",  "interfaces", "passes",
                                            "outputs", "views"};

}  // namespace

bool isName(std::string_view name)
{
    const auto allowed = [](char c) { return isLower(c) || isDigit(c) || c == '_'; };
    return !name.empty() && isLower(name.front()) && name.size() <= kMaxNameBytes &&
           std::all_of(name.begin(), name.end(), allowed) &&
           name.find("__") == std::string_view::npos && name.substr(0, 3) != "gl_";
}

Place lastPlace(const Node& object)
{
    Place place = object.place;
    for (const Member& member : object.members)
        if (member.value.place.source != object.place.source) place = member.value.place;
    return place;
}

void checkName(Report& report, const Cursor& cursor)
{
    if (isName(cursor.key)) return;
    report.atKey(cursor, Code::bad_name,
                 "found the name '" + cursor.key + "', wanted snake_case of at most " +
                     std::to_string(kMaxNameBytes) + " letters, without '__' or 'gl_'",
                 "write lower-case letters, digits and '_', a letter first: ao_blur");
}

void reportUndeclared(Report& report, const Cursor& section, const Cursor& entry)
{
    if (report.full()) return report.count();
    const bool plural = section.key.back() == 's';
    const std::string what = plural ? section.key.substr(0, section.key.size() - 1) : section.key;
    Reported& error =
        report.atKey(entry, Code::unknown_param,
                     what + " '" + entry.key + "' is set here, and no file declares it");
    error.help = report.otherSection(section.key, entry.key);
    if (!error.help.empty()) return;
    if (report.leavesOut(entry.key_place)) return Report::leaveOut(error);
    std::vector<std::string> declared;
    for (const Member& member : section.node.members)
        if (member.value.kind == Node::Kind::object) declared.push_back(member.key);
    error.help = declaredBy(report.sources, section.key, entry.key) +
                 suggestName(entry.key, declared, section.key) +
                 "; to declare one of your own, write {\"default\": " + brief(entry.node) + "}";
    for (const Member& gone : section.node.deleted)
        if (gone.key == entry.key)
            error.notes.push_back({gone.key_place, "what declared it was left out here"});
}

void Reader::refuse(const char* key, Code code, const char* reason)
{
    const Member* member = find(key);
    if (!member) return;
    const Cursor value = cursor_.child(*member);
    report_.atValue(value, code, value.label + ": " + reason,
                    "leave out '" + std::string(key) + "'");
}

void Reader::ordered(const char* min_key, double& min, const char* max_key, double& max)
{
    if (min <= max) return;
    const Member* at = find(min_key) ? find(min_key) : find(max_key);
    report_.atValue(cursor_.child(*at), Code::bad_range,
                    cursor_.key + ": '" + min_key + "' is above '" + max_key + "'",
                    "swap them, or leave out one");
    min = -kMaxParam;
    max = kMaxParam;
}

bool Reader::finish()
{
    if (!has_keys_) return true;
    if (!expectObject(report_, cursor_, keys_)) return false;
    if (!reportUnknown())  // else the key that is missing was surely meant
        for (const auto& [key, doc] : missing_) reportMissing(key, doc);
    return missing_.empty();
}

// Whether there was one.
bool Reader::reportUnknown()
{
    bool reported = false;
    if (cursor_.pointer.empty())
        keys_.insert(keys_.end(), {"extends", "needs", "replaces", "variants"});
    for (const Member& member : cursor_.node.members) {
        if (contains(keys_, member.key) || isExtension(member.key)) continue;
        if (report_.full()) {
            report_.count();
            continue;
        }
        std::string help =
            cursor_.pointer.empty() ? report_.otherSection("", member.key) : std::string();
        if (contains(kSections, member.key)) help = "it stands at the top of a config";
        if (help.empty() && !startsWith(help = suggestName(member.key, keys_, "keys"), "did you"))
            help += "; a key of your own begins with 'x-'";
        reported = true;
        report_.atKey(cursor_.child(member), Code::unknown_key,
                      "found the key '" + member.key + "', which the format does not have here",
                      std::move(help));
    }
    return reported;
}

// At the null of the patch that took it away, where there is one.
void Reader::reportMissing(const std::string& key, const std::string& doc)
{
    const std::string where = cursor_.key.empty() ? "the config" : "'" + cursor_.key + "'";
    const std::string message = where + " has no '" + key + "', which must be there";
    for (const Member& deleted : cursor_.node.deleted)
        if (deleted.key == key) {
            report_.atKey(cursor_.child(deleted), Code::missing_key, message,
                          "give it a value instead of null, or leave it as it was");
            return;
        }
    report_.atKey(cursor_, Code::missing_key, message, "add \"" + key + "\": " + doc);
}

const Member* Reader::find(std::string_view key) const
{
    for (const Member& member : cursor_.node.members)
        if (member.key == key) return &member;
    return nullptr;
}

}  // namespace crevice::table
