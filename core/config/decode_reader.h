// SPDX-License-Identifier: MIT
// The visitor of core/config/fields.h that decodes. Each `read` turns a JSON value into a member
// and says whether it could; where not, it has reported why and the member keeps its default.
#pragma once

#include "core/config/decode_report.h"
#include "core/config/field_types.h"

#include <type_traits>

namespace crevice::table {

bool read(Report& report, const Cursor& cursor, bool& out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, std::string& out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, Reference& out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, std::vector<Reference>& out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, std::vector<Format>& out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, std::map<std::string, std::string>& out,
          const Rule& rule);
bool read(Report& report, const Cursor& cursor, Numbers out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, Words out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, Choice out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, OneOf out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, Scalars out, const Rule& rule);
bool read(Report& report, const Cursor& cursor, ProductDesc& out, const Rule& rule);
inline bool read(Report&, const Cursor&, Later, const Rule&) { return true; }

/// Whether the value is a number, a whole one where asked for, inside both ranges.
bool isNumber(Report& report, const Cursor& cursor, bool whole, Rule rule, double least,
              double most);

/// The index of the string among `words`.
bool readWord(Report& report, const Cursor& cursor, const std::vector<std::string>& words,
              std::size_t& index);

/// CV3002 unless the value is an object. The help lists `keys`, where there are some.
bool expectObject(Report& report, const Cursor& cursor, const std::vector<std::string>& keys = {});

/// Lower-case letters, digits and single underscores, a letter first, at most 64 bytes, no "gl_".
bool isName(std::string_view name);

/// Where an object was changed: its place, or that of a member that another file set.
Place lastPlace(const Node& object);

/// CV3004 unless the cursor's key is a name that JSON, GLSL and C++ can share.
void checkName(Report& report, const Cursor& cursor);

/// Whether some file says what an entry of that list is. Else files only give it a value.
template <class T>
bool isDeclared(const std::vector<T>&, const Node& entry)
{
    if (std::is_same_v<T, GeneratedDesc>) return entry.find("generator") != nullptr;
    const bool tunable = std::is_same_v<T, ParamDesc> || std::is_same_v<T, FeatureDesc>;
    return !tunable || entry.kind == Node::Kind::object;
}

/// CV3002 where a file gives a param or feature another type than that which declares it.
bool isRetyped(Report& report, const Cursor& entry);

/// CV4004 about a value of what no file declares; a warning where it is left out.
void reportUndeclared(Report& report, const Cursor& section, const Cursor& entry);

class Reader {
public:
    Reader(Report& report, const Cursor& cursor) : report_(report), cursor_(cursor) {}

    template <class T>
    bool field(const char* key, T&& out, const char* doc, const Rule& rule = {})
    {
        keys_.push_back(key);
        if (const Member* member = find(key)) {
            Cursor value = cursor_.child(*member);
            value.doc = doc;
            return read(report_, value, out, rule);
        }
        if (rule.required) missing_.push_back({key, doc});
        return !rule.required;
    }

    template <class T>
    bool shorthand(const char* key, T&& out, const char* doc, const Rule& rule = {})
    {
        if (cursor_.node.kind == Node::Kind::object) return field(key, out, doc, rule);
        return itself(out, doc, rule);
    }

    template <class T>
    bool itself(T&& out, const char* doc, const Rule& rule = {})
    {
        has_keys_ = false;
        cursor_.doc = doc;
        return read(report_, cursor_, out, rule);
    }

    bool has(const char* key) const { return find(key) != nullptr; }
    void refuse(const char* key, Code code, const char* reason);
    void ordered(const char* min_key, double& min, const char* max_key, double& max);

    /// To be called last: reports keys that no field has, and a value that is no object.
    bool finish();

private:
    const Member* find(std::string_view key) const
    {
        for (const Member& member : cursor_.node.members)
            if (member.key == key) return &member;
        return nullptr;
    }
    bool reportUnknown();
    void reportMissing(const std::string& key, const std::string& doc);

    Report& report_;
    Cursor cursor_;
    std::vector<std::string> keys_ = {};
    std::vector<std::pair<std::string, std::string>> missing_ = {};  // required keys and their docs
    bool has_keys_ = true;  // false when the value is not written as an object with keys
};

template <class T>
bool read(Report& report, const Cursor& cursor, NumberOrName<T> out, const Rule& rule)
{
    const Node& node = cursor.node;
    const bool name =
        node.kind == Node::Kind::string && !(node.text[0] >= '0' && node.text[0] <= '9');
    if (name) return read(report, cursor, out.name, rule);
    return read(report, cursor, out.number, rule);
}

// An object of entries by name. One that is broken keeps it, so that what refers to it is right.
template <class T>
bool read(Report& report, const Cursor& cursor, std::vector<T>& out, const Rule&)
{
    if (!expectObject(report, cursor)) return false;
    for (const Member& member : cursor.node.members) {
        if (isExtension(member.key)) continue;
        const Cursor child = cursor.child(member);
        const bool declared = isDeclared(out, member.value);
        const bool elided = !declared && (report.leavesOut(child.key_place) ||
                                          !report.otherSection(cursor.key, child.key).empty());
        const bool bare = member.value.kind != Node::Kind::object;
        if (!elided) {
            T& entry = out.emplace_back();
            entry.name = child.key;
            entry.place = child.key_place;
            entry.pointer = child.pointer;
            if (!std::is_base_of_v<Reference, T>) checkName(report, child);
        }
        if (elided || (!declared && bare))
            reportUndeclared(report, cursor, child);
        else
            read(report, child, out.back(), {});
    }
    return true;
}

// A number, an enum, or a struct of the table.
template <class T>
bool read(Report& report, const Cursor& cursor, T& out, const Rule& rule)
{
    if constexpr (std::is_arithmetic_v<T>) {
        using Limits = std::numeric_limits<T>;
        const bool whole = Limits::is_integer;
        if (!isNumber(report, cursor, whole, rule, Limits::lowest(), Limits::max())) return false;
        out = static_cast<T>(cursor.node.number);
        return true;
    } else if constexpr (std::is_enum_v<T>) {
        std::size_t index = 0;
        if (!readWord(report, cursor, spellings(out), index)) return false;
        out = static_cast<T>(index);
        return true;
    } else {
        const bool typed = std::is_same_v<T, ParamDesc> || std::is_same_v<T, FeatureDesc>;
        if (typed && isRetyped(report, cursor)) return false;
        Reader reader(report, cursor);
        fields(reader, out);
        if constexpr (std::is_same_v<T, SizeDesc>) out.place = lastPlace(cursor.node);
        if constexpr (std::is_same_v<T, TargetDesc>)
            if (const Node* formats = cursor.node.find("format"))
                out.formats_place = formats->place;
        return reader.finish();
    }
}

}  // namespace crevice::table
