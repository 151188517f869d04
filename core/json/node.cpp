// SPDX-License-Identifier: MIT
// Looking into a document's tree, and showing a value in a message.
#include <crevice/document.h>

#include "core/base/text.h"

#include <cmath>

namespace crevice {

namespace {

constexpr std::size_t kBriefBytes = 40;

// As JSON, until there are more than that many bytes.
void append(std::string& out, const Node& node, std::size_t bytes)
{
    switch (node.kind) {
    case Node::Kind::null: out += "null"; return;
    case Node::Kind::boolean: out += node.boolean ? "true" : "false"; return;
    case Node::Kind::number: out += node.text; return;
    case Node::Kind::string: out += jsonString(utf8Prefix(node.text, 2 * bytes)); return;
    case Node::Kind::array:
        out += '[';
        for (std::size_t i = 0; i < node.items.size() && out.size() <= bytes; ++i) {
            if (i > 0) out += ", ";
            append(out, node.items[i], bytes);
        }
        out += ']';
        return;
    case Node::Kind::object:
        out += '{';
        for (std::size_t i = 0; i < node.members.size() && out.size() <= bytes; ++i) {
            out += (i > 0 ? ", " : "") + jsonString(node.members[i].key) + ": ";
            append(out, node.members[i].value, bytes);
        }
        out += '}';
        return;
    }
}

}  // namespace

bool Node::integer() const
{
    constexpr double kExact = 9007199254740992.0;  // 2^53: above it doubles skip integers
    return kind == Kind::number && text.find_first_of(".eE") == text.npos &&
           std::fabs(number) <= kExact;
}

const Node* Node::find(std::string_view key) const
{
    for (const Member& member : members)
        if (member.key == key) return &member.value;
    return nullptr;
}

Node* Node::find(std::string_view key)
{
    return const_cast<Node*>(static_cast<const Node*>(this)->find(key));
}

std::string brief(const Node& node)
{
    std::string out;
    append(out, node, kBriefBytes);
    if (out.size() <= kBriefBytes) return out;
    return std::string(utf8Prefix(out, kBriefBytes)) + "...";
}

std::string toJson(const Node& node)
{
    std::string out;
    append(out, node, std::string::npos / 2);  // no limit, even where it is doubled
    return out;
}

const char* kindName(Node::Kind kind)
{
    static const char* const kNames[] = {"null", "boolean", "number", "string", "array", "object"};
    return kNames[static_cast<int>(kind)];
}

}  // namespace crevice
