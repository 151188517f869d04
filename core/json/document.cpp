// SPDX-License-Identifier: MIT
// JSON text to a tree with places.
#include <crevice/document.h>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/json/merge.h"
#include "core/json/syntax.h"

// Core is built without exceptions, while a program that links it may use nlohmann-json with them.
// Both would emit inline functions of the same names but other content, of which the linker keeps
// one at random. A namespace of our own keeps them apart.
#define NLOHMANN_JSON_NAMESPACE nlohmann::crevice_core
#define NLOHMANN_JSON_NAMESPACE_BEGIN \
    namespace nlohmann { \
    inline namespace crevice_core {
#define NLOHMANN_JSON_NAMESPACE_END \
    } \
    }
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace crevice {

namespace {

using Json = nlohmann::json;

// Receives the events of nlohmann-json's parser and builds the tree. The events carry no position,
// but they come in the order of the text: the builder goes with them from token to token.
class TreeBuilder {
public:
    // `text` is that of the source as strict JSON.
    TreeBuilder(const SourceRef& source, std::string_view text) : source_(source), text_(text)
    {
        take(0);
    }

    // The names of these thirteen are the parser's.
    bool null() { return add(Node::Kind::null, 4); }
    bool boolean(bool value);
    bool number_integer(std::int64_t value);
    bool number_unsigned(std::uint64_t value) { return number(std::to_string(value).size()); }
    bool number_float(double, const std::string& text) { return number(text.size()); }
    bool string(std::string& value);
    bool binary(Json::binary_t&) { return false; }  // JSON text has none
    bool start_object(std::size_t) { return open(Node::Kind::object); }
    bool key(std::string& name);
    bool end_object();
    bool start_array(std::size_t) { return open(Node::Kind::array); }
    bool end_array() { return close(); }
    bool parse_error(std::size_t, const std::string&, const Json::exception&);

    // The tree, or every error found. `whole` is what the parser returned.
    Result<Node> finish(bool whole);

private:
    Place take(std::size_t length);
    Node* add(Node::Kind kind, std::size_t length);
    bool number(std::size_t length);
    bool open(Node::Kind kind);
    bool close();
    std::string pointer() const;
    void checkKeys();

    SourceRef source_;
    std::string_view text_;
    std::size_t end_ = 0;  // behind the last token
    std::size_t at_ = 0;   // of the token behind that
    std::size_t line_begin_ = 0;
    int line_ = 1;
    SyntaxStop::After after_ = SyntaxStop::After::nothing;
    Node root_;
    std::vector<Node*> open_;  // outermost first; stable, as only the last of them grows
    Diagnostics errors_;
};

// The place of the token, from which it moves to the next one.
Place TreeBuilder::take(std::size_t length)
{
    const Place place{source_, line_, static_cast<int>(at_ - line_begin_) + 1,
                      static_cast<int>(length)};
    end_ = at_ + length;
    at_ = std::min(text_.find_first_not_of(" \t\r\n,:", end_), text_.size());
    for (std::size_t i = end_; i < at_; ++i)
        if (text_[i] == '\n') {
            ++line_;
            line_begin_ = i + 1;
        }
    return place;
}

Node* TreeBuilder::add(Node::Kind kind, std::size_t length)
{
    Node* node = &root_;
    if (!open_.empty() && open_.back()->kind == Node::Kind::array)
        node = &open_.back()->items.emplace_back();
    else if (!open_.empty())
        node = &open_.back()->members.back().value;
    node->kind = kind;
    node->place = take(length);
    after_ = SyntaxStop::After::value;
    return node;
}

bool TreeBuilder::boolean(bool value)
{
    add(Node::Kind::boolean, value ? 4 : 5)->boolean = value;
    return true;
}

// A negative one, or -0.
bool TreeBuilder::number_integer(std::int64_t value)
{
    return number(value == 0 ? 2 : std::to_string(value).size());
}

// Read by our own function, which the host's locale does not change.
bool TreeBuilder::number(std::size_t length)
{
    const std::string_view written = text_.substr(at_, length);
    Node* node = add(Node::Kind::number, length);
    node->text = written;
    node->number = *parseNumber(written);
    return true;
}

bool TreeBuilder::string(std::string& value)
{
    add(Node::Kind::string, stringLength(text_, at_))->text = std::move(value);
    return true;
}

bool TreeBuilder::key(std::string& name)
{
    if (open_.back()->members.size() == kMaxMembers) {
        errors_.push_back(tooManyMembers(take(stringLength(text_, at_)), pointer()));
        return false;
    }
    open_.back()->members.push_back({std::move(name), take(stringLength(text_, at_)), {}});
    after_ = SyntaxStop::After::key;
    return true;
}

bool TreeBuilder::open(Node::Kind kind)
{
    if (open_.size() == kMaxDocumentDepth) {
        errors_.push_back({Code::too_deep,
                           "found more than " + std::to_string(kMaxDocumentDepth) +
                               " levels of objects and arrays",
                           "is a closing bracket missing? no config is that deep", take(1)});
        return false;
    }
    open_.push_back(add(kind, 1));
    after_ = SyntaxStop::After::opening;
    return true;
}

bool TreeBuilder::close()
{
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

// By a map, because comparing each key with each takes minutes for a file made of nothing but keys.
void TreeBuilder::checkKeys()
{
    std::map<std::string_view, Place> first;
    for (const Member& member : open_.back()->members) {
        const auto [known, fresh] = first.emplace(member.key, member.key_place);
        if (fresh) continue;
        errors_.push_back({Code::duplicate_key,
                           "found the key '" + member.key + "' a second time",
                           "keep one of them",
                           member.key_place,
                           memberPointer(pointer(), member.key),
                           {{known->second, "the first one is here"}}});
    }
}

bool TreeBuilder::parse_error(std::size_t read, const std::string&, const Json::exception& cause)
{
    const Node* container = open_.empty() ? nullptr : open_.back();
    const bool in_string = std::strstr(cause.what(), "invalid string");
    Diagnostic error =
        explainSyntax({source_, text_, end_, after_, container, in_string ? read - 1 : 0});
    error.pointer = pointer();
    const Member* last = after_ == SyntaxStop::After::key ? &container->members.back() : nullptr;
    if (last && (error.place.line != last->key_place.line ||
                 error.place.column != last->key_place.column))  // it is not about the key itself
        error.pointer = memberPointer(error.pointer, last->key);
    errors_.push_back(std::move(error));
    for (; !open_.empty(); open_.pop_back()) checkKeys();
    return false;
}

Result<Node> TreeBuilder::finish(bool whole)
{
    // The parser takes a zero byte for the end of the text.
    if (whole && at_ < text_.size())
        errors_.push_back(explainSyntax({source_, text_, end_, after_, nullptr}));
    if (errors_.empty()) return std::move(root_);
    std::stable_sort(errors_.begin(), errors_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    cutShort(errors_);
    return std::move(errors_);
}

// What makes a text unreadable before its first token is looked at.
Status checkText(const SourceRef& source)
{
    const std::string_view text = source->text;
    if (text.size() > kMaxDocumentBytes)
        return Diagnostic{Code::too_large,
                          "found more than the 1048576 bytes (1 MiB) that are read",
                          "is this a config? the largest of them has a few thousand bytes",
                          {source, 1, 1}};
    if (startsWith(text, "\xEF\xBB\xBF"))
        return Diagnostic{Code::bad_utf8, "found a byte order mark",
                          "save the file as UTF-8 without a byte order mark",
                          placeAt(source, 0, 3)};
    for (std::size_t at = 0, length; at < text.size(); at += length) {
        length = utf8Length(text, at);
        if (length == 0)
            return Diagnostic{Code::bad_utf8, "found a byte that is not UTF-8",
                              "save the file as UTF-8", placeAt(source, at)};
    }
    return {};
}

// Bytes of the comment at `at`; 0 when none begins there, npos when it does not end.
std::size_t commentLength(std::string_view text, std::size_t at)
{
    const std::string_view opening = text.substr(at, 2);
    if (opening == "//") return std::min(text.find_first_of("\r\n", at), text.size()) - at;
    if (opening != "/*") return 0;
    const std::size_t end = text.find("*/", at + 2);
    return end == text.npos ? end : end + 2 - at;
}

// Makes strict JSON of a text: comments, and commas behind the last entry, become blanks. All else
// stays where it is.
Status blankOut(const SourceRef& source, std::string& text)
{
    std::size_t comma = 0;  // behind an entry, with only blanks and comments since; 0 is none
    bool entry = false;     // that is what ended last
    for (std::size_t at = 0, length; at < text.size(); at += length) {
        const char c = text[at];
        const std::size_t comment = commentLength(text, at);
        if (comment == text.npos)
            return Diagnostic{Code::syntax, "found a comment that does not end",
                              "close it with '*/'", placeAt(source, at, 2)};
        for (std::size_t i = at; i < at + comment; ++i)
            if (text[i] != '\n') text[i] = ' ';
        length = comment > 0 ? comment : spaceLength(text, at);
        if (length > 0) continue;
        length = c == '"' ? stringLength(text, at) : 1;
        if (comma > 0 && (c == ']' || c == '}')) text[comma] = ' ';
        comma = entry && c == ',' ? at : 0;
        entry = c != ',' && c != ':' && c != '[' && c != '{';
    }
    return {};
}

Result<Node> parseText(const SourceRef& source)
{
    std::string text = source->text;
    Status status = checkText(source);
    if (status) status = blankOut(source, text);
    if (!status) return status.diagnostics();
    if (spaceLength(text, 0) == text.size())
        return Diagnostic{Code::empty_text,
                          "found nothing but white space and comments",
                          "begin with { \"format\": 1 }",
                          {source, 1, 1}};
    TreeBuilder builder(source, text);
    return builder.finish(Json::sax_parse(text, &builder));
}

// True for what is meant as JSON, and whose faults are worth a message; anything else is a word.
bool looksLikeJson(std::string_view text)
{
    const bool number = isDigit(text[text[0] == '-' && text.size() > 1 ? 1 : 0]) &&
                        text.find_first_not_of("+-.0123456789eE") == text.npos;  // not 50cm
    return number || text[0] == '"' || text[0] == '{' || text[0] == '[' || text == "true" ||
           text == "false" || text == "null";
}

}  // namespace

Result<Node> parseDocument(const SourceRef& source)
{
    Result<Node> document = parseText(source);
    if (!document || document->kind == Node::Kind::object) return document;
    return Diagnostic{Code::not_an_object,
                      "found " + brief(*document) + " where an object was wanted",
                      "a document begins with '{'", document->place};
}

Result<Node> parseValue(const SourceRef& source)
{
    const std::string_view text = source->text;
    const std::size_t begin = spaceLength(text, 0);
    const std::string_view word = text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
    if (word.empty() || looksLikeJson(word)) return parseText(source);
    const Status status = checkText(source);
    if (!status) return status.diagnostics();
    return textNode(std::string(word), placeAt(source, begin, word.size()));
}

}  // namespace crevice
