// SPDX-License-Identifier: MIT
// Documents: JSON as a tree in which every key and value keeps its place.
//
// Comments (// and /* */) and a comma behind the last entry are read. All else is strict, because a
// swallowed typo costs an afternoon: duplicate keys, numbers that no double holds, bad UTF-8, a
// byte order mark, more than 64 levels, 1024 members of an object or 1 MiB are errors.
#pragma once

#include <crevice/diagnostic.h>

#include <cstdint>

namespace crevice {

constexpr int kMaxDocumentDepth = 64;

/// Members of an object, also after merging: what is searched by name stays fast.
constexpr std::size_t kMaxMembers = 1024;

struct Member;

/// One JSON value.
struct Node {
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    bool boolean = false;         ///< Of a boolean.
    double number = 0;            ///< Of a number.
    std::string text;             ///< The string, or the number as it was written.
    std::vector<Node> items;      ///< Of an array.
    std::vector<Member> members;  ///< Of an object, in the order of the text.
    /// The nulls of patches that took members away; at the top of a config also the modules that it
    /// leaves out, each with a string that says why.
    std::vector<Member> deleted;
    std::vector<Place> origins;  ///< The places that set it before, oldest first.
    Place place;                 ///< Where it stands now.

    /// True for a number written without '.' and 'e' that fits 53 bits.
    bool integer() const;

    /// The member's value, or null when there is none or this is no object.
    const Node* find(std::string_view key) const;
    Node* find(std::string_view key);
};

struct Member {
    std::string key;
    Place key_place;
    Node value;
};

/// The value as a user would write it on one line, cut to about 40 characters.
std::string brief(const Node& node);

/// The value as JSON on one line.
std::string toJson(const Node& node);

/// "null", "boolean", "number", "string", "array" or "object".
const char* kindName(Node::Kind kind);

/// Reads a document. Its top value must be an object.
///
/// Errors: CV1001 to CV1009, with the place of the first offending character.
Result<Node> parseDocument(const SourceRef& source);

/// Reads a value of any kind, as behind `--set radius=`. A word that is not JSON is a string.
Result<Node> parseValue(const SourceRef& source);

}  // namespace crevice
