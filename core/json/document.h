// SPDX-License-Identifier: MIT
// Documents: JSON as a tree in which every key and value keeps its place.
//
// Reading is strict, because a swallowed typo costs an afternoon: duplicate keys, numbers that no
// double holds, bad UTF-8, a byte order mark, more than 64 levels and more than 1 MiB are errors.
// nlohmann-json's SAX parser does the reading; its DOM is too lenient (it keeps the last of two
// equal keys and reads 16.7 as the int 16).
#pragma once

#include "core/base/result.h"
#include "core/json/lazy.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

constexpr int kMaxDocumentDepth = 64;

struct Member;

/// One JSON value. A file may hold half a million of them, so a node is small: a text, a number and
/// a flag are read where they stand in the source, and all else takes room only where it is there.
struct Node {
    enum class Kind : std::uint8_t { null, boolean, number, string, array, object };
    struct Contents;

    Kind kind = Kind::null;
    std::uint32_t offset = 0;  ///< Bytes of `place.source->text` before it.
    Place place;               ///< Where it stands now.

    bool boolean() const;      ///< False when it is none.
    double number() const;     ///< 0 when it is none.
    bool integer() const;      ///< A number written without '.' and 'e' that fits 53 bits.
    std::string text() const;  ///< The string, or the number as it was written.

    const std::vector<Node>& items() const;      ///< Of an array.
    const std::vector<Member>& members() const;  ///< Of an object, in the order of the text.
    const std::vector<Member>& deleted() const;  ///< The nulls of patches that took members away.
    const std::vector<Place>& origins() const;   ///< The places that set it before, oldest first.

    /// The four lists, to be changed.
    Contents& change() { return contents_.change(); }

    /// The member's value, or null when there is none or this is no object.
    const Node* find(std::string_view key) const;
    Node* find(std::string_view key);

private:
    Lazy<Contents> contents_;
};

struct Member {
    std::string key;
    Place key_place;
    Node value;
};

struct Node::Contents {
    std::vector<Node> items;
    std::vector<Member> members;
    std::vector<Member> deleted;
    std::vector<Place> origins;
};

inline const std::vector<Node>& Node::items() const { return contents_.get().items; }
inline const std::vector<Member>& Node::members() const { return contents_.get().members; }
inline const std::vector<Member>& Node::deleted() const { return contents_.get().deleted; }
inline const std::vector<Place>& Node::origins() const { return contents_.get().origins; }

/// The value as a user would write it on one line, cut to about 40 characters.
std::string brief(const Node& node);

/// The value as JSON on one line.
std::string toJson(const Node& node);

/// "null", "boolean", "number", "string", "array" or "object".
const char* kindName(Node::Kind kind);

/// Reads a document. Its top value must be an object.
///
/// Errors: CV1001 to CV1008, with the place of the first offending character.
Result<Node> parseDocument(const SourceRef& source);

/// Reads one value of any kind, such as the right side of `--set radius=0.8`. A word that is not
/// JSON is taken as a string.
Result<Node> parseValue(const SourceRef& source);

}  // namespace crevice
