// SPDX-License-Identifier: MIT
// Looking into a document's tree, and showing a value in a message.
#include "core/document.h"

#include "core/text.h"

namespace crevice {

namespace {

constexpr std::size_t kBriefBytes = 40;

void appendBrief(std::string& out, const Node& node)
{
    const auto full = [&] { return out.size() > kBriefBytes; };
    switch (node.kind) {
    case Node::Kind::null: out += "null"; return;
    case Node::Kind::boolean: out += node.boolean ? "true" : "false"; return;
    case Node::Kind::number: out += node.text; return;
    case Node::Kind::string: out += jsonString(utf8Prefix(node.text, 2 * kBriefBytes)); return;
    case Node::Kind::array:
        out += '[';
        for (std::size_t i = 0; i < node.items.size() && !full(); ++i) {
            if (i > 0) out += ", ";
            appendBrief(out, node.items[i]);
        }
        out += ']';
        return;
    case Node::Kind::object:
        out += '{';
        for (std::size_t i = 0; i < node.members.size() && !full(); ++i) {
            out += (i > 0 ? ", " : "") + jsonString(node.members[i].key) + ": ";
            appendBrief(out, node.members[i].value);
        }
        out += '}';
        return;
    }
}

}  // namespace

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
    appendBrief(out, node);
    if (out.size() <= kBriefBytes) return out;
    return std::string(utf8Prefix(out, kBriefBytes)) + "...";
}

const char* kindName(Node::Kind kind)
{
    static const char* const kNames[] = {"null", "boolean", "number", "string", "array", "object"};
    return kNames[static_cast<int>(kind)];
}

}  // namespace crevice
