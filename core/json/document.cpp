// SPDX-License-Identifier: MIT
// JSON text to a tree with places.
#include "core/json/document.h"

#include "core/base/text.h"
#include "core/json/json_parser.h"
#include "core/json/syntax.h"

#include <algorithm>
#include <tuple>

namespace crevice {

namespace {

using Json = nlohmann::json;

// How many entries each object and array has, in the order of their opening brackets; for a broken
// text any numbers. With the room made beforehand no tree is moved while it grows, which would cost
// more than all the rest of reading it.
std::vector<std::uint32_t> countEntries(std::string_view text)
{
    std::vector<std::uint32_t> counts;
    std::vector<std::size_t> open;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            for (++at; at < text.size() && text[at] != '"'; ++at)
                if (text[at] == '\\') ++at;
        } else if (c == '[' || c == '{') {
            open.push_back(counts.size());
            counts.push_back(1);
        } else if (!open.empty() && (c == ']' || c == '}')) {
            open.pop_back();
        } else if (!open.empty() && c == ',') {
            ++counts[open.back()];
        }
    }
    return counts;
}

// The first eight bytes of a key as a number that is in the same order.
std::uint64_t firstBytes(std::string_view key)
{
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < 8; ++i)
        bytes = bytes << 8 | (i < key.size() ? static_cast<unsigned char>(key[i]) : 0u);
    return bytes;
}

// A member by its key, and of equal keys by its place; few comparisons have to look at the member.
struct SortedKey {
    std::uint64_t first_bytes;
    const Member* member;

    bool operator<(const SortedKey& other) const
    {
        return std::tie(first_bytes, member->key, member) <
               std::tie(other.first_bytes, other.member->key, other.member);
    }
};

// Receives the events of nlohmann-json's parser and builds the tree. The events carry no position,
// but they come in the order of the text: a cursor follows them from token to token. Values are read
// again where somebody asks for them.
class TreeBuilder {
public:
    explicit TreeBuilder(const SourceRef& source)
        : source_(source), text_(source->text), counts_(countEntries(text_)) {}

    // The names of these thirteen are the parser's.
    bool null() { return addLeaf(Node::Kind::null); }
    bool boolean(bool) { return addLeaf(Node::Kind::boolean); }
    bool number_integer(std::int64_t) { return addLeaf(Node::Kind::number); }
    bool number_unsigned(std::uint64_t) { return addLeaf(Node::Kind::number); }
    bool number_float(double, const std::string&) { return addLeaf(Node::Kind::number); }
    bool string(std::string&) { return addLeaf(Node::Kind::string); }
    bool binary(Json::binary_t&) { return false; }  // JSON text has none
    bool start_object(std::size_t) { return open(Node::Kind::object); }
    bool key(std::string& name);
    bool end_object();
    bool start_array(std::size_t) { return open(Node::Kind::array); }
    bool end_array() { return close(); }
    bool parse_error(std::size_t, const std::string&, const Json::exception&);

    // The tree, or every error found. Call once, when the parser is done.
    Result<Node> finish();

private:
    void moveToToken();
    std::size_t tokenLength() const;
    Place take(std::size_t length);
    Node& add(Node::Kind kind, std::size_t length);
    bool addLeaf(Node::Kind kind);
    bool open(Node::Kind kind);
    void reserve(Node& node);
    bool close();
    std::string pointer() const;
    void checkKeys();

    SourceRef source_;
    std::string_view text_;
    std::vector<std::uint32_t> counts_;  // of the entries of what opens next, and then
    std::size_t opened_ = 0;
    std::size_t at_ = 0;  // behind the last token
    std::size_t line_begin_ = 0;
    int line_ = 1;
    SyntaxStop::After after_ = SyntaxStop::After::nothing;
    bool stopped_ = false;
    Node root_;
    std::vector<Node*> open_;  // outermost first; stable, as only the last of them grows
    Diagnostics errors_;
};

void TreeBuilder::moveToToken()
{
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == '\n') {
            ++line_;
            line_begin_ = at_ + 1;
        } else if (c != ' ' && c != '\t' && c != '\r' && c != ',' && c != ':') {
            return;
        }
    }
}

// Of a string, number or word, which the parser has found to be one.
std::size_t TreeBuilder::tokenLength() const
{
    switch (text_[at_]) {
    case 't':
    case 'n': return 4;
    case 'f': return 5;
    case '"': break;
    default: return numberLength(text_, at_);
    }
    std::size_t end = at_ + 1;
    while (text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    return end + 1 - at_;
}

Place TreeBuilder::take(std::size_t length)
{
    const Place place{source_, line_, static_cast<int>(at_ - line_begin_) + 1,
                      static_cast<int>(length)};
    at_ += length;
    return place;
}

Node& TreeBuilder::add(Node::Kind kind, std::size_t length)
{
    Node* node = &root_;
    if (!open_.empty() && open_.back()->kind == Node::Kind::array)
        node = &open_.back()->change().items.emplace_back();
    else if (!open_.empty())
        node = &open_.back()->change().members.back().value;
    node->kind = kind;
    node->offset = static_cast<std::uint32_t>(at_);
    node->place = take(length);
    after_ = SyntaxStop::After::value;
    return *node;
}

bool TreeBuilder::addLeaf(Node::Kind kind)
{
    moveToToken();
    add(kind, tokenLength());
    return true;
}

bool TreeBuilder::key(std::string& name)
{
    moveToToken();
    const Place place = take(tokenLength());
    open_.back()->change().members.push_back({std::move(name), place, {}});
    after_ = SyntaxStop::After::key;
    return true;
}

bool TreeBuilder::open(Node::Kind kind)
{
    moveToToken();
    if (open_.size() == kMaxDocumentDepth) {
        errors_.push_back({Code::too_deep, "found more than " + std::to_string(kMaxDocumentDepth) +
                           " levels of objects and arrays", take(1), {}, {},
                           "is a closing bracket missing? no config is that deep"});
        stopped_ = true;
        return false;
    }
    Node& node = add(kind, 1);
    reserve(node);
    open_.push_back(&node);
    after_ = SyntaxStop::After::opening;
    return true;
}

// An item takes two bytes at least and a member five, whatever a broken text may count.
void TreeBuilder::reserve(Node& node)
{
    const std::size_t count = counts_[opened_++];
    const std::size_t next = at_ + spaceLength(text_, at_), left = text_.size() - at_;
    if (next == text_.size() || text_[next] == ']' || text_[next] == '}') return;
    if (node.kind == Node::Kind::array)
        node.change().items.reserve(std::min(count, left / 2 + 1));
    else
        node.change().members.reserve(std::min(count, left / 5 + 1));
}

bool TreeBuilder::close()
{
    moveToToken();
    take(1);
    open_.pop_back();
    after_ = SyntaxStop::After::value;
    return true;
}

bool TreeBuilder::end_object()
{
    checkKeys();
    return close();
}

// Of the innermost object or array.
std::string TreeBuilder::pointer() const
{
    std::string path;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
        const Node& node = *open_[i];
        path = node.kind == Node::Kind::object
                   ? memberPointer(path, node.members().back().key)
                   : path + '/' + std::to_string(node.items().size() - 1);
    }
    return path;
}

// Sorted, because comparing each key with each takes minutes for a file made of nothing but keys.
void TreeBuilder::checkKeys()
{
    const std::vector<Member>& members = open_.back()->members();
    if (members.size() < 2) return;
    std::vector<SortedKey> keys;
    for (const Member& member : members) keys.push_back({firstBytes(member.key), &member});
    std::sort(keys.begin(), keys.end());
    const Member* first = nullptr;
    for (const SortedKey& key : keys) {
        if (!first || key.member->key != first->key) {
            first = key.member;
            continue;
        }
        errors_.push_back({Code::duplicate_key, "found the key '" + first->key + "' a second time",
                           key.member->key_place, memberPointer(pointer(), first->key),
                           {{first->key_place, "the first one is here"}}, "keep one of them"});
    }
}

bool TreeBuilder::parse_error(std::size_t, const std::string&, const Json::exception&)
{
    const Node* container = open_.empty() ? nullptr : open_.back();
    Diagnostic error = explainSyntax(source_, {at_, after_, container});
    const auto isAt = [&error](const Place& place) {
        return error.place.line == place.line && error.place.column == place.column;
    };
    error.pointer = pointer();
    if (container && !container->members().empty()) {
        const Member& last = container->members().back();
        const bool value = after_ == SyntaxStop::After::key && !isAt(last.key_place);
        if (value || isAt(last.value.place)) error.pointer = memberPointer(error.pointer, last.key);
    }
    errors_.push_back(std::move(error));
    for (; !open_.empty(); open_.pop_back()) checkKeys();
    stopped_ = true;
    return false;
}

Result<Node> TreeBuilder::finish()
{
    // The parser takes a zero byte for the end of the text.
    if (!stopped_ && at_ + spaceLength(text_, at_) < text_.size())
        errors_.push_back(explainSyntax(source_, {at_, after_, nullptr}));
    if (errors_.empty()) return std::move(root_);
    std::stable_sort(errors_.begin(), errors_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    return std::move(errors_);
}

// What makes a text unreadable before its first token is looked at.
Status checkText(const SourceRef& source)
{
    const std::string_view text = source->text;
    if (text.size() > kMaxDocumentBytes)
        return Diagnostic{Code::too_large, "found more than the 1048576 bytes (1 MiB) that are read",
                          {source, 1, 1}, {}, {},
                          "is this a config? the largest of them has a few thousand bytes"};
    if (text.substr(0, 3) == "\xEF\xBB\xBF")
        return Diagnostic{Code::bad_utf8, "found a byte order mark", placeAt(source, 0, 3), {}, {},
                          "save the file as UTF-8 without a byte order mark"};
    if (spaceLength(text, 0) == text.size())
        return Diagnostic{Code::empty_text, "found nothing but white space", {source, 1, 1}, {}, {},
                          "begin with { \"format\": 1 }"};
    for (std::size_t at = 0; at < text.size();) {
        if (static_cast<unsigned char>(text[at]) < 0x80) {
            ++at;
            continue;
        }
        const std::size_t length = utf8Length(text, at);
        if (length == 0)
            return Diagnostic{Code::bad_utf8, "found a byte that is not UTF-8", placeAt(source, at),
                              {}, {}, "save the file as UTF-8"};
        at += length;
    }
    return {};
}

Result<Node> parseText(const SourceRef& source)
{
    const Status status = checkText(source);
    if (!status) return status.diagnostics();
    TreeBuilder builder(source);
    const char* begin = source->text.data();
    Json::sax_parse(begin, begin + source->text.size(), &builder);
    return builder.finish();
}

// True for what is meant as JSON, and whose faults are worth a message; anything else is a word.
bool looksLikeJson(std::string_view text)
{
    const std::size_t sign = text[0] == '+' || text[0] == '-' || text[0] == '.' ? 1 : 0;
    const char first = sign < text.size() ? text[sign] : '\0';
    return text[0] == '-' || (first >= '0' && first <= '9') || text[0] == '"' || text[0] == '{' ||
           text[0] == '[';
}

}  // namespace

Result<Node> parseDocument(const SourceRef& source)
{
    Result<Node> document = parseText(source);
    if (!document || document->kind == Node::Kind::object) return document;
    return Diagnostic{Code::not_an_object, "found " + brief(*document) +
                      " where an object was wanted", document->place, {}, {},
                      "a document begins with '{'"};
}

Result<Node> parseValue(const SourceRef& source)
{
    Result<Node> value = parseText(source);
    if (value || value.diagnostics().front().code != Code::syntax) return value;
    const std::string_view text = source->text;
    const std::size_t begin = spaceLength(text, 0);
    const std::string_view word = text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
    if (looksLikeJson(word)) return value;
    Node node;
    node.kind = Node::Kind::string;
    node.offset = static_cast<std::uint32_t>(begin);
    node.place = placeAt(source, begin, word.size());
    return node;
}

}  // namespace crevice
