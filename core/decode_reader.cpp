// SPDX-License-Identifier: MIT
// What the decoding visitor does with keys: missing, unknown, refused, badly named.
#include "core/decode_reader.h"

#include <algorithm>

namespace crevice::table {

namespace {

// One GLSL line holds it with room to spare, and the shortest limit among drivers is far longer.
constexpr std::size_t kMaxNameBytes = 64;

bool isLower(char c)
{
    return c >= 'a' && c <= 'z';
}

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

// `name` as it should have been spelt: "AoRadius" and "ao-radius" become "ao_radius".
std::string spellName(std::string_view name)
{
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool hump = isUpper(name[i]) && i > 0 && !isUpper(name[i - 1]);
        const bool kept = isLower(name[i]) || isUpper(name[i]) || isDigit(name[i]);
        if ((hump || !kept) && !out.empty() && out.back() != '_') out += '_';
        if (kept) out += isUpper(name[i]) ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
    }
    while (!out.empty() && out.back() == '_') out.pop_back();
    if (out.substr(0, 3) == "gl_") out.erase(0, 3);
    if (out.empty()) return "name";
    if (!isLower(out.front())) out.insert(0, "my_");
    return out.substr(0, kMaxNameBytes);
}

}  // namespace

bool isName(std::string_view name)
{
    const auto allowed = [](char c) { return isLower(c) || isDigit(c) || c == '_'; };
    return !name.empty() && isLower(name.front()) && name.size() <= kMaxNameBytes &&
           std::all_of(name.begin(), name.end(), allowed) &&
           name.find("__") == std::string_view::npos && name.substr(0, 3) != "gl_";
}

void checkName(Report& report, const Cursor& cursor)
{
    if (isName(cursor.key)) return;
    report.atKey(cursor, Code::bad_name,
                 "found the name '" + cursor.key + "', wanted snake_case of at most " +
                     std::to_string(kMaxNameBytes) + " letters, without '__' or 'gl_'")
        .help = "write '" + spellName(cursor.key) + "'";
}

void Reader::refuse(const char* key, Code code, const char* reason)
{
    const Member* member = find(key);
    if (!member) return;
    const Cursor value = cursor_.child(*member);
    report_.atValue(value, code, value.label + ": " + reason).help =
        "leave out '" + std::string(key) + "'";
}

void Reader::ordered(const char* min_key, double& min, const char* max_key, double& max)
{
    if (min <= max) return;
    const Member* at = find(min_key) ? find(min_key) : find(max_key);
    report_.atValue(cursor_.child(*at), Code::bad_range,
                    cursor_.key + ": '" + min_key + "' is above '" + max_key + "'")
        .help = "swap them, or leave out one";
    min = -kMaxParam;
    max = kMaxParam;
}

bool Reader::finish()
{
    if (!has_keys_) return true;
    if (!expectObject(report_, cursor_)) return false;
    for (const Member& member : cursor_.node.members) {
        const bool known = std::find(keys_.begin(), keys_.end(), member.key) != keys_.end();
        if (known || isExtension(member.key)) continue;
        report_.atKey(cursor_.child(member), Code::unknown_key,
                      "found the key '" + member.key + "', which the format does not have here")
            .help = suggestName(member.key, keys_, "keys");
    }
    return true;
}

const Member* Reader::find(std::string_view key) const
{
    for (const Member& member : cursor_.node.members)
        if (member.key == key) return &member;
    return nullptr;
}

Cursor Reader::child(const Member& member, const char* doc) const
{
    Cursor cursor = cursor_.child(member);
    cursor.doc = doc;
    return cursor;
}

bool Reader::missing(const char* key, const char* doc)
{
    if (cursor_.node.kind != Node::Kind::object) return false;  // `finish` says so
    const std::string where = cursor_.key.empty() ? "the config" : "'" + cursor_.key + "'";
    report_.atKey(cursor_, Code::missing_key, where + " has no '" + key + "', which must be there")
        .help = std::string("add \"") + key + "\": " + doc;
    return false;
}

}  // namespace crevice::table
