// SPDX-License-Identifier: MIT
// JSON text to a tree with places; looking into that, and showing a value in a message.
#include <crevice/document.h>

#include "core/base/files.h"
#include "core/base/text.h"
#include "core/json/merge.h"

#include <charconv>
#include <cmath>

namespace crevice {
namespace {

constexpr std::size_t kMaxShown = 40;  // bytes of an offending token in a message

constexpr const char* kPairs =
    "an object holds pairs, with the key in double quotes: \"key\": value";
constexpr const char* kValue =
    "text stands in double quotes, true, false and null are in lower case, and a number is finite "
    "and looks like 12, -0.5 or 1e-3, decimal and without a unit";
constexpr const char* kPlain =
    "outside of text JSON is plain: ordinary spaces, straight double quotes \" and hyphens -";
constexpr const char* kMerge =
    "a merge left both sides here: keep one, and delete the lines of '<', '=' and '>'";

// The place of `length` bytes at `offset`, as far as its line goes.
Place placeAt(const SourceRef& source, std::size_t offset, std::size_t length = 1)
{
    const std::string_view text = source->text;
    const std::string_view before = text.substr(0, offset);
    const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    const std::size_t line_end = std::min(text.find('\n', offset), text.size());
    Place place{source};
    place.line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
    place.column = static_cast<int>(before.size() - line_begin) + 1;
    place.length = static_cast<int>(std::max<std::size_t>(std::min(length, line_end - offset), 1));
    return place;
}

std::string quotedToken(std::string_view token)
{
    const std::string shown = printableLine(utf8Prefix(token, kMaxShown));
    return "'" + shown + (token.size() > kMaxShown ? "...'" : "'");
}

// Bytes of white space at `at`.
std::size_t spaceLength(std::string_view text, std::size_t at)
{
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size()) - at;
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

// Whether it is a number as JSON writes it: none of 01, .5, 5. and +1 is.
bool isNumber(std::string_view text)
{
    const std::string_view whole = text.substr(startsWith(text, "-"));
    const auto digit = [&](std::size_t at) { return at < whole.size() && isDigit(whole[at]); };
    const std::size_t point = whole.find('.');
    return digit(0) && !(whole[0] == '0' && digit(1)) && (point == text.npos || digit(point + 1)) &&
           parseNumber(text);
}

void appendUtf8(std::string& out, std::uint32_t code)
{
    if (code < 0x80) return out.push_back(static_cast<char>(code));
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    out += static_cast<char>((0xF0u << (3 - more) & 0xF0u) | code >> 6 * more);
    for (int i = more; i-- > 0;) out += static_cast<char>(0x80u | (code >> 6 * i & 0x3Fu));
}

// The XXXX of a \uXXXX at the front of the text; above 0xFFFF where there is none.
std::uint32_t unicodeOf(std::string_view text)
{
    std::uint32_t code = 0;
    if (text.size() < 6 || !startsWith(text, "\\u")) return ~code;
    const char* const end = text.data() + 6;
    return std::from_chars(text.data() + 2, end, code, 16).ptr == end ? code : ~0u;
}

// Appends what the escape at the front of the text stands for. Its bytes; 0 where it is none.
std::size_t appendEscape(std::string& out, std::string_view text)
{
    const std::size_t known = std::string_view("\"\\/bfnrt").find(text[1]);
    if (known != text.npos) {
        out += "\"\\/\b\f\n\r\t"[known];
        return 2;
    }
    const std::uint32_t code = unicodeOf(text);
    const std::uint32_t low = unicodeOf(text.substr(std::min<std::size_t>(6, text.size())));
    const bool pair = code >= 0xD800 && code < 0xDC00 && low >= 0xDC00 && low < 0xE000;
    if (!pair && (code > 0xFFFF || (code >= 0xD800 && code < 0xE000))) return 0;
    appendUtf8(out, pair ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : code);
    return pair ? 12 : 6;
}

// Reads token by token, up to the first that makes no sense.
class Parser {
public:
    explicit Parser(const SourceRef& source) : source_(source), text_(source->text) { take(0); }

    // The tree, or every error found.
    Result<Node> run()
    {
        Node root;
        if (at_ == text_.size())
            return Diagnostic{Code::empty_text, "found nothing but white space and comments",
                              "begin with { \"format\": 1 }", placeAt(source_, 0)};
        if (read(root, "a value", "a document begins with '{'") && at_ < text_.size())
            fail("the end of the text", "a text holds one value, an object within braces");
        if (errors_.empty()) return root;
        const auto before = [](const Diagnostic& a, const Diagnostic& b) {
            return std::pair(a.place.line, a.place.column) <
                   std::pair(b.place.line, b.place.column);
        };
        std::stable_sort(errors_.begin(), errors_.end(), before);
        cutShort(errors_);
        return std::move(errors_);
    }

private:
    char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void advance(std::size_t length)
    {
        for (const std::size_t end = at_ + length; at_ < end; ++at_)
            if (text_[at_] == '\n') {
                ++line_;
                line_begin_ = at_ + 1;
            }
    }

    // The place of the token, from which it moves to the next one.
    Place take(std::size_t length)
    {
        const Place place{source_, line_, static_cast<int>(at_ - line_begin_) + 1,
                          static_cast<int>(length)};
        advance(length);
        end_ = at_;
        const auto blank = [&] {
            return std::max(spaceLength(text_, at_), commentLength(text_, at_));
        };
        for (std::size_t next = blank(); next > 0; next = blank()) {
            if (next == text_.npos) {
                stop({Code::syntax, "found a comment that does not end", "close it with '*/'",
                      placeAt(source_, at_, 2)});
                break;
            }
            advance(next);
        }
        return place;
    }

    bool take(Node& node, Node::Kind kind, std::size_t length)
    {
        node.kind = kind;
        node.place = take(length);
        keyed_ = false;
        return true;
    }

    bool read(Node& node, const char* wanted, const char* help = kValue)
    {
        if (here() == '{' || here() == '[') return readAll(node);
        const bool string = here() == '"';
        const std::size_t length = string ? readString(node.text) : wordLength();
        if (string) return length > 0 && take(node, Node::Kind::string, length);
        const std::string_view word = text_.substr(at_, length);
        if (word == "null") return take(node, Node::Kind::null, length);
        node.boolean = word == "true";
        if (node.boolean || word == "false") return take(node, Node::Kind::boolean, length);
        if (!isNumber(word)) return fail(wanted, help);
        node.text = word;
        node.number = *parseNumber(word);
        if (std::isfinite(node.number)) return take(node, Node::Kind::number, length);
        return stop({Code::number_range, "the number " + quotedToken(word) + " is too large",
                     "the largest number is about 1.8e308", placeAt(source_, at_, length)});
    }

    // An object or array.
    bool readAll(Node& node)
    {
        const bool object = here() == '{';
        const char close = object ? '}' : ']';
        if (open_.size() == kMaxDocumentDepth)
            return stop({Code::too_deep,
                         "found more than " + std::to_string(kMaxDocumentDepth) +
                             " levels of objects and arrays",
                         "is a closing bracket missing? no config is that deep", take(1)});
        take(node, object ? Node::Kind::object : Node::Kind::array, 1);
        open_.push_back(&node);  // stable, as only the last of them grows
        const char* wanted = object ? "a key or '}'" : "a value or ']'";
        while (here() != close) {
            if (object ? !readMember(node, wanted) : !read(node.items.emplace_back(), wanted))
                return false;
            if (here() == close) break;
            if (here() != ',')
                return fail(object ? "',' or '}'" : "',' or ']'",
                            object ? "is a comma missing before it? or close with '}'"
                                   : "is a comma missing before it? or close with ']'");
            take(1);
            wanted = object ? "a key" : "a value";
        }
        checkKeys(open_.size() - 1);
        open_.pop_back();
        take(1);
        return true;
    }

    bool readMember(Node& node, const char* wanted)
    {
        if (here() != '"') return fail(wanted, kPairs);
        std::string name;
        const std::size_t length = readString(name);
        if (length == 0) return false;
        if (node.members.size() == kMaxMembers) return stop(tooManyMembers(take(length), {}));
        node.members.push_back({std::move(name), take(length), {}});
        keyed_ = true;
        if (here() != ':') return fail("':'", "write ':' between a key and its value");
        take(1);
        return read(node.members.back().value, "a value");
    }

    // Bytes of the number or word here, be it right or wrong, at least one character.
    std::size_t wordLength() const
    {
        const auto belongs = [](char c) { return isWord(c) || has("$+-.", {&c, 1}); };
        std::size_t end = at_;
        while (end < text_.size() && belongs(text_[end])) ++end;
        if (end > at_ || end == text_.size()) return end - at_;
        return std::max<std::size_t>(utf8Length(text_, at_), 1);
    }

    // Bytes of the string here, with its quotes; 0, with an error, where it is broken.
    std::size_t readString(std::string& out)
    {
        const auto ends = [this](std::size_t at) {
            return at >= text_.size() || text_[at] == '\n' || text_[at] == '\r';
        };
        std::size_t at = at_ + 1;
        while (!ends(at) && !(text_[at] == '\\' && ends(at + 1))) {
            const char c = text_[at];
            if (c == '"') return at + 1 - at_;
            std::size_t length = static_cast<unsigned char>(c) >= 0x20;
            if (c == '\\')
                length = appendEscape(out, text_.substr(at));
            else
                out += c;
            if (length == 0) return refuse(at);
            at += length;
        }
        stop({Code::syntax, "found a string that does not end on its line",
              "close it with '\"'; a line break in a string is written \\n",
              placeAt(source_, at_, at - at_)});
        return 0;
    }

    // A byte or an escape that no string has.
    std::size_t refuse(std::size_t at)
    {
        const std::string_view text = text_.substr(at, 6);
        std::size_t length = 1;
        if (text[0] == '\\') length += std::max<std::size_t>(utf8Length(text, 1), 1);
        if (startsWith(text, "\\u"))
            while (length < text.size() && isWord(text[length])) ++length;
        const std::string_view whole = text_.substr(0, text_.find_first_of("\"\r\n", at));
        const std::string path = text[0] == '\\' ? slashed(*source_, whole.substr(at_ + 1)) : "";
        stop({Code::syntax, "found " + quotedToken(text.substr(0, length)) + " in a string",
              (path.empty() ? "" : path + "; ") +
                  "a backslash is written \\\\, a quote \\\", a tab \\t, a line break \\n",
              placeAt(source_, at, length)});
        return 0;
    }

    // What is here, or the end of the text, is not what was wanted.
    bool fail(const std::string& wanted, const char* help)
    {
        const Node* const container = open_.empty() ? nullptr : open_.back();
        const std::string kind = container ? kindName(container->kind) : "";
        Diagnostic error{Code::syntax, {}};
        if (at_ == text_.size()) {
            error.message = "the text ends inside an " + kind;
            error.help = kind == "object" ? "close it with '}'" : "close it with ']'";
            error.place = placeAt(source_, end_ - 1);
        } else {
            std::string ignored;
            const std::size_t length = here() == '"' ? readString(ignored) : wordLength();
            if (length == 0) return false;
            const std::string found = codePoint(text_, at_) < 0x80
                                          ? quotedToken(text_.substr(at_, length))
                                          : characterName(text_, at_);
            error.message = "found " + found + " where " + wanted + " was wanted";
            error.help = helpFor(wanted, help);
            error.place = placeAt(source_, at_, length);
        }
        if (container && (at_ == text_.size() || here() == ']' || here() == '}'))
            error.notes.push_back({container->place, "the " + kind + " begins here"});
        return stop(std::move(error));
    }

    // The way out of what is here, where it is a common slip.
    const char* helpFor(const std::string& wanted, const char* usual) const
    {
        if (codePoint(text_, at_) >= 0x80) return kPlain;
        if (here() == ';') return "write ',' between pairs or values, and none behind the last";
        if (here() == '#') return "a comment begins with //";
        for (const char* marker : {"<<<<<<<", "|||||||", "=======", ">>>>>>>"})
            if (at_ == line_begin_ && startsWith(text_.substr(at_), marker)) return kMerge;
        const bool comma = wanted == "a key" && at_ == end_ && isDigit(here());
        return comma && isDigit(text_[at_ - 2]) ? "a number has a decimal point: 0.8" : usual;
    }

    // Reports what ends the reading. Nothing behind it can be told.
    bool stop(Diagnostic error)
    {
        if (std::exchange(stopped_, true)) return false;
        if (error.code != Code::too_deep)  // whose pointer is as deep
            error.pointer = pointer(open_.size() - (keyed_ || open_.empty() ? 0 : 1));
        errors_.push_back(std::move(error));
        for (std::size_t i = 0; i < open_.size(); ++i) checkKeys(i);
        return false;
    }

    // Of what is being read in so many of the open objects and arrays.
    std::string pointer(std::size_t count) const
    {
        std::string path;
        for (std::size_t i = 0; i < count; ++i)
            path = open_[i]->kind == Node::Kind::object
                       ? memberPointer(path, open_[i]->members.back().key)
                       : path + '/' + std::to_string(open_[i]->items.size() - 1);
        return path;
    }

    // By a map, because comparing each key with each takes minutes for a file of nothing but keys.
    void checkKeys(std::size_t open)
    {
        std::map<std::string_view, Place> first;
        for (const Member& member : open_[open]->members) {
            const auto [known, fresh] = first.emplace(member.key, member.key_place);
            if (fresh) continue;
            errors_.push_back(
                {Code::duplicate_key, "found the key '" + member.key + "' a second time",
                 "keep one of them", member.key_place, memberPointer(pointer(open), member.key)});
            errors_.back().notes.push_back({known->second, "the first one is here"});
        }
    }

    const SourceRef& source_;
    const std::string_view text_;
    std::size_t end_ = 0;  // behind the last token
    std::size_t at_ = 0;   // of the token behind that
    std::size_t line_begin_ = 0;
    int line_ = 1;
    bool keyed_ = false;       // a key was read, and not its value
    std::vector<Node*> open_;  // outermost first
    bool stopped_ = false;
    Diagnostics errors_;
};

// What makes a text unreadable before its first token is looked at.
Status checkText(const SourceRef& source)
{
    const std::string_view text = source->text;
    if (text.size() > kMaxDocumentBytes)
        return Diagnostic{
            Code::too_large, "found more than the 1048576 bytes (1 MiB) that are read",
            "is this a config? the largest of them has a few thousand bytes", placeAt(source, 0)};
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

Result<Node> parseText(const SourceRef& source)
{
    if (Status status = checkText(source); !status) return status.diagnostics();
    return Parser(source).run();
}

// True for what is meant as JSON, and whose faults are worth a message; anything else is a word.
bool looksLikeJson(std::string_view text)
{
    const bool number = isDigit(text[text[0] == '-' && text.size() > 1 ? 1 : 0]) &&
                        text.find_first_not_of("+-.0123456789eE") == text.npos;  // not 50cm
    return number || text[0] == '"' || text[0] == '{' || text[0] == '[' || text == "true" ||
           text == "false" || text == "null";
}

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
