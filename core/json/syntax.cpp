// SPDX-License-Identifier: MIT
// What is wrong with a text that is not JSON.
#include "core/json/syntax.h"

#include "core/base/text.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace crevice {

namespace {

constexpr std::size_t kMaxShown = 40;  // bytes of an offending token in a message

bool isOneOf(char c, const char* set) { return c != '\0' && std::strchr(set, c) != nullptr; }

bool isWordCharacter(char c) { return isWord(c) || c == '$'; }

char charAt(std::string_view text, std::size_t offset)
{
    return offset < text.size() ? text[offset] : '\0';
}

std::size_t digitsLength(std::string_view text, std::size_t offset)
{
    std::size_t end = offset;
    while (isDigit(charAt(text, end))) ++end;
    return end - offset;
}

std::string quoted(std::string_view token)
{
    std::string out = "'";
    out += utf8Prefix(token, kMaxShown);
    return out + (token.size() > kMaxShown ? "...'" : "'");
}

// A fault at a stretch of the text.
struct Fault {
    std::size_t offset = 0;
    std::size_t length = 1;
    std::string message;
    std::string help;
    Code code = Code::syntax;
};

constexpr const char* kPairs = "an object holds pairs: \"key\": value";

// What the grammar allows behind the stop, and where that would begin.
struct Wanted {
    std::size_t offset = 0;
    const char* what = "";
    const char* help = "";  // when something well formed stands there instead
    bool value = false;     // a value would do
    bool after_comma = false;
};

Wanted wantedAfter(std::string_view text, const SyntaxStop& stop)
{
    using After = SyntaxStop::After;
    const bool in_object = stop.container && stop.container->kind == Node::Kind::object;
    const auto skip = [&](std::size_t offset) { return offset + spaceLength(text, offset); };
    const std::size_t at = skip(stop.offset);
    if (stop.after == After::nothing) return {at, "a value", "a document begins with '{'", true};
    if (stop.after == After::opening && in_object) return {at, "a key or '}'", kPairs};
    if (stop.after == After::opening) return {at, "a value or ']'", "", true};
    if (stop.after == After::key && charAt(text, at) == ':')
        return {skip(at + 1), "a value", "", true};
    if (stop.after == After::key) return {at, "':'", "write ':' between a key and its value"};
    if (!stop.container) return {at, "the end of the text", "a text holds one value"};
    if (charAt(text, at) == ',')
        return {skip(at + 1), in_object ? "a key" : "a value", in_object ? kPairs : "", !in_object,
                true};
    return {at, in_object ? "',' or '}'" : "',' or ']'",
            isDigit(charAt(text, stop.offset - 1))
                ? "is a comma missing before it? a number stands without a unit"
                : "is a comma missing before it?"};
}

Fault unexpected(std::size_t offset, std::size_t length, const std::string& found,
                 const Wanted& wanted, std::string help)
{
    return {offset, length, "found " + found + " where " + wanted.what + " was wanted",
            std::move(help)};
}

// What is wrong with the string at `begin`, which the byte at `bad` breaks.
Fault stringFault(std::string_view text, std::size_t begin, std::size_t bad)
{
    const char c = charAt(text, bad);
    if (bad >= text.size() || c == '\n' || text.substr(bad, 2) == "\r\n")
        return {begin, std::min(bad, text.size()) - begin,
                "found a string that does not end on its line",
                "close it with '\"'; a line break in a string is written \\n"};
    if (c == '\t') return {bad, 1, "found a tab in a string", "write it as \\t"};
    if (static_cast<unsigned char>(c) < 0x20)
        return {bad, 1, "found a control character in a string",
                "write it as " + printableLine({&c, 1})};
    std::size_t escape = text.rfind('\\', bad - 1);
    if (isOneOf(text[escape + 1], "\"\\/bfnrt")) escape -= 6;  // it stands behind half of a pair
    const std::size_t digits = text.find_first_not_of("0123456789abcdefABCDEF", escape + 2);
    if (text[escape + 1] == 'u' && digits - escape >= 6)
        return {escape, 6, "found half of a surrogate pair in a string",
                "write the character itself, in UTF-8"};
    return {escape, 2, "found " + quoted(text.substr(escape, 2)) + " in a string",
            "a backslash is written \\\\, a quote \\\", a line break \\n"};
}

std::string wordHelp(std::string_view word, const Wanted& wanted)
{
    const std::string lower = lowerCase(word);
    const std::string bare = lower.substr(isOneOf(lower[0], "+-") ? 1 : 0);
    if (bare == "nan" || bare == "infinity" || bare == "inf")
        return "JSON has finite numbers only; for no limit write a large one, such as 1e30";
    if (lower != word && (lower == "true" || lower == "false" || lower == "null"))
        return "write it in lower case: " + lower;
    if (lower == "none" || lower == "nil" || lower == "undefined") return "write null";
    if (wanted.help[0] != '\0' && wanted.help != kPairs) return wanted.help;
    return "put keys and text in double quotes: \"" + std::string(utf8Prefix(word, kMaxShown)) +
           "\"";
}

Fault wordFault(std::string_view text, const Wanted& wanted)
{
    const auto belongs = [&](std::size_t at) {
        return isWordCharacter(charAt(text, at)) || isOneOf(charAt(text, at), "+-.");
    };
    std::size_t begin = wanted.offset, end = wanted.offset;
    while (begin > 0 && belongs(begin - 1)) --begin;  // the parser stopped inside of 01
    while (belongs(end)) ++end;
    const std::string_view token = text.substr(begin, end - begin);
    const std::size_t sign = isOneOf(token[0], "+-") ? 1 : 0;
    const char first = charAt(token, sign);
    // 0,5 and 1,000 in an object end the value at the comma.
    if (wanted.after_comma && begin > 1 && text[begin - 1] == ',' && isDigit(text[begin - 2]) &&
        isDigit(token[0]))
        return unexpected(begin, token.size(), quoted(token), wanted,
                          "a decimal number is written with a point, 0.5, and 1000 without comma");
    if (begin > 0 && text[begin - 1] == '"')
        return unexpected(begin, token.size(), quoted(token), wanted,
                          "does it belong to the text before? a quote in a text is written \\\"");
    if (!isDigit(first) && !isOneOf(first, ".+-") && token.size() > sign)
        return unexpected(begin, token.size(), quoted(token), wanted, wordHelp(token, wanted));
    if (numberLength(token, 0) != token.size())
        return {begin, token.size(), "found " + quoted(token) + ", which is not a number",
                "a number looks like 12, -0.5 or 1e-3: decimal, without '+', leading zeros or a "
                "unit, with a digit before the point and one after the point"};
    if (wanted.value)
        return {begin, token.size(), "the number " + quoted(token) + " is too large",
                "the largest number is about 1.8e308", Code::number_range};
    return unexpected(begin, token.size(), quoted(token), wanted, wanted.help);
}

// What to do about a sign that JSON does not have there.
std::string symbolHelp(std::string_view text, const SyntaxStop& stop, const Wanted& wanted)
{
    const char c = text[wanted.offset];
    const bool after_value = stop.after == SyntaxStop::After::value;
    if (c == ':' && !stop.container) return "put braces around all of it: { \"format\": 1, ... }";
    if (c == ':' && stop.container->kind == Node::Kind::array)
        return "a list has no keys: close it with ']' first, or write '{' for its '['";
    if (c == ',' && stop.after != SyntaxStop::After::key)
        return wanted.after_comma ? "take one of the two commas away" : "take the comma away";
    if (isOneOf(c, "]}")) {
        if (!stop.container) return "take it away; or is an opening one missing above?";
        if (stop.after == SyntaxStop::After::key)
            return "write ':' and a value behind the key, or take the key away";
        return stop.container->kind == Node::Kind::array ? "close the array with ']' first"
                                                         : "close the object with '}' first";
    }
    if (c == ';' && after_value)
        return stop.container ? "write ',' between entries" : "take it away";
    if (c == '%') return "write a share, such as 0.5";
    if (c == '#') return "a comment begins with '//'";
    if (isOneOf(c, "/*") && after_value) return "JSON does not calculate: write the result";
    return wanted.help;
}

Fault symbolFault(std::string_view text, const SyntaxStop& stop, const Wanted& wanted)
{
    const std::size_t length = std::max<std::size_t>(utf8Length(text, wanted.offset), 1);
    const std::string_view symbol = text.substr(wanted.offset, length);
    const char c = symbol[0];
    std::string found = quoted(symbol);
    std::string help = symbolHelp(text, stop, wanted);
    if (isOneOf(c, "'`") || symbol == "\u2018" || symbol == "\u201C" || symbol == "\u201D") {
        found = c == '\'' ? "a single quote" : c == '`' ? "a backtick" : "a curly quote";
        help = "put keys and text in double quotes: \"";
    } else if (static_cast<unsigned char>(c) < 0x20) {
        found = "a control character";
        help = "take it away";
    }
    return unexpected(wanted.offset, length, found, wanted, help);
}

// A string that lacks its closing quote ends at the next one's opening quote, and what follows
// makes no sense: "radius: { "default". True when the last string ends in what stands between
// entries.
bool lacksQuote(std::string_view text, const SyntaxStop& stop, std::size_t offset)
{
    if (stop.offset == 0 || text[stop.offset - 1] != '"' || !isWordCharacter(charAt(text, offset)))
        return false;
    std::size_t end = stop.offset - 1;
    while (end > 0 && text[end - 1] == ' ') --end;
    return end > 0 && isOneOf(text[end - 1], ",:[{");
}

Fault faultAt(std::string_view text, const SyntaxStop& stop, const Wanted& wanted)
{
    const char c = text[wanted.offset];
    if (lacksQuote(text, stop, wanted.offset)) {
        const std::size_t begin = text.rfind('"', stop.offset - 2);
        return {begin, stop.offset - begin,
                "found " + quoted(text.substr(begin, stop.offset - begin)) +
                    ", which looks like a string without its closing quote",
                "close it with '\"' where it should end"};
    }
    if (isWordCharacter(c) || isOneOf(c, "+-.")) return wordFault(text, wanted);
    if (c != '"') return symbolFault(text, stop, wanted);
    if (stop.bad > 0) return stringFault(text, wanted.offset, stop.bad);
    const std::size_t length = stringLength(text, wanted.offset);
    return unexpected(wanted.offset, length, quoted(text.substr(wanted.offset, length)), wanted,
                      wanted.help);
}

Fault endFault(std::string_view text, const SyntaxStop& stop, const Wanted& wanted)
{
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    if (!stop.container)
        return {last, 1, std::string("the text ends where ") + wanted.what + " was wanted", {}};
    return {last, 1, std::string("the text ends inside an ") + kindName(stop.container->kind),
            stop.container->kind == Node::Kind::object ? "close it with '}'" : "close it with ']'"};
}

}  // namespace

Diagnostic explainSyntax(const SourceRef& source, const SyntaxStop& stop)
{
    const std::string_view text = stop.text;
    const Wanted wanted = wantedAfter(text, stop);
    const bool at_end = wanted.offset >= text.size();
    const Fault fault = at_end ? endFault(text, stop, wanted) : faultAt(text, stop, wanted);
    Diagnostic diagnostic{fault.code, fault.message, fault.help,
                          placeAt(source, fault.offset, fault.length)};
    if (stop.container && (at_end || isOneOf(text[wanted.offset], "]}")))
        diagnostic.notes.push_back(
            {stop.container->place,
             std::string("the ") + kindName(stop.container->kind) + " begins here"});
    return diagnostic;
}

Place placeAt(const SourceRef& source, std::size_t offset, std::size_t length)
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

std::size_t spaceLength(std::string_view text, std::size_t offset)
{
    return std::min(text.find_first_not_of(" \t\r\n", offset), text.size()) - offset;
}

std::size_t stringLength(std::string_view text, std::size_t offset)
{
    std::size_t end = offset + 1;
    while (!isOneOf(charAt(text, end), "\"\n") && end < text.size())
        end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size()) - offset;
}

std::size_t numberLength(std::string_view text, std::size_t offset)
{
    std::size_t end = offset + (charAt(text, offset) == '-' ? 1 : 0);
    const std::size_t whole = charAt(text, end) == '0' ? 1 : digitsLength(text, end);
    if (whole == 0) return 0;
    end += whole;
    if (charAt(text, end) == '.' && isDigit(charAt(text, end + 1)))
        end += 1 + digitsLength(text, end + 1);
    if ((charAt(text, end) | 32) == 'e') {
        const std::size_t sign = isOneOf(charAt(text, end + 1), "+-") ? 1 : 0;
        const std::size_t digits = digitsLength(text, end + 1 + sign);
        if (digits > 0) end += 1 + sign + digits;
    }
    return end - offset;
}

}  // namespace crevice
