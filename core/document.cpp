// SPDX-License-Identifier: MIT
// JSON text to a tree with places.
#include "core/document.h"

#include "core/syntax.h"
#include "core/text.h"

// This file is built without exceptions, while a program that links it may use nlohmann-json with
// them. Both would emit inline functions of the same names but other content, of which the linker
// keeps one at random. A namespace of our own keeps them apart.
#define NLOHMANN_JSON_NAMESPACE nlohmann::crevice_core
#define NLOHMANN_JSON_NAMESPACE_BEGIN namespace nlohmann { inline namespace crevice_core {
#define NLOHMANN_JSON_NAMESPACE_END } }
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

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

// Receives the events of nlohmann-json's parser and builds the tree. The events carry no position,
// but they come in the order of the text: a cursor follows them from token to token.
class TreeBuilder {
public:
    explicit TreeBuilder(const SourceRef& source)
        : source_(source), text_(source->text), counts_(countEntries(text_)) {}

    // The names of these thirteen are the parser's.
    bool null() { return addValue(Node::Kind::null, 4); }
    bool boolean(bool value) { return addBoolean(value); }
    bool number_integer(std::int64_t value) { return addInteger(static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return addInteger(static_cast<double>(value)); }
    bool number_float(double value, const std::string&) { return addNumber(value, false); }
    bool string(std::string& value);
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
    std::size_t stringLength() const;
    Place take(std::size_t length);
    Node& add(Node::Kind kind, std::size_t length);
    bool addValue(Node::Kind kind, std::size_t length);
    bool addBoolean(bool value);
    bool addInteger(double value);
    bool addNumber(double value, bool integer);
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

std::size_t TreeBuilder::stringLength() const
{
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
        node = &open_.back()->items.emplace_back();
    else if (!open_.empty())
        node = &open_.back()->members.back().value;
    node->kind = kind;
    node->place = take(length);
    after_ = SyntaxStop::After::value;
    return *node;
}

bool TreeBuilder::addValue(Node::Kind kind, std::size_t length)
{
    moveToToken();
    add(kind, length);
    return true;
}

bool TreeBuilder::addBoolean(bool value)
{
    moveToToken();
    add(Node::Kind::boolean, value ? 4 : 5).boolean = value;
    return true;
}

bool TreeBuilder::addInteger(double value)
{
    constexpr double kExact = 9007199254740992.0;  // 2^53: above it doubles skip integers
    return addNumber(value, std::fabs(value) <= kExact);
}

bool TreeBuilder::addNumber(double value, bool integer)
{
    moveToToken();
    const std::size_t length = numberLength(text_, at_);
    const std::string_view written = text_.substr(at_, length);
    Node& node = add(Node::Kind::number, length);
    node.number = value;
    node.integer = integer;
    node.text = written;
    return true;
}

bool TreeBuilder::string(std::string& value)
{
    moveToToken();
    add(Node::Kind::string, stringLength()).text = std::move(value);
    return true;
}

bool TreeBuilder::key(std::string& name)
{
    moveToToken();
    const Place place = take(stringLength());
    open_.back()->members.push_back({std::move(name), place, {}});
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
    if (node.kind == Node::Kind::array) node.items.reserve(std::min(count, left / 2 + 1));
    else node.members.reserve(std::min(count, left / 5 + 1));
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
        path = node.kind == Node::Kind::object ? memberPointer(path, node.members.back().key)
                                               : path + '/' + std::to_string(node.items.size() - 1);
    }
    return path;
}

// Sorted, because comparing each key with each takes minutes for a file made of nothing but keys.
void TreeBuilder::checkKeys()
{
    const Node& object = *open_.back();
    if (object.members.size() < 2) return;
    std::vector<const Member*> sorted;
    for (const Member& member : object.members) sorted.push_back(&member);
    std::sort(sorted.begin(), sorted.end(), [](const Member* a, const Member* b) {
        const int order = a->key.compare(b->key);
        return order != 0 ? order < 0 : a < b;
    });
    const Member* first = sorted.front();
    for (auto at = sorted.begin() + 1; at != sorted.end(); ++at) {
        if ((*at)->key != first->key) {
            first = *at;
            continue;
        }
        errors_.push_back({Code::duplicate_key, "found the key '" + first->key + "' a second time",
                           (*at)->key_place, memberPointer(pointer(), first->key),
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
    if (container && !container->members.empty()) {
        const Member& last = container->members.back();
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
        return Diagnostic{Code::too_large, "found " + std::to_string(text.size()) +
                          " bytes where at most 1048576 (1 MiB) are read", {source, 1, 1}, {}, {},
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
    node.text = word;
    node.place = placeAt(source, begin, word.size());
    return node;
}

}  // namespace crevice
