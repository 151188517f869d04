// SPDX-License-Identifier: MIT
// What is wrong with a text that is not JSON.
#include "core/json/syntax.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <cmath>
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

std::string quotedToken(std::string_view token)
{
    std::string out = "'";
    out += utf8Prefix(token, kMaxShown);
    return out + (token.size() > kMaxShown ? "...'" : "'");
}

// What the grammar allows behind the stop, where that would begin, and how it is written.
struct Wanted {
    std::size_t offset = 0;
    const char* what = "";
    const char* help = "";
};

constexpr const char* kPairs =
    "an object holds pairs, with the key in double quotes: \"key\": value";
constexpr const char* kValue =
    "text stands in double quotes, true, false and null are in lower case, and a number is finite "
    "and looks like 12, -0.5 or 1e-3, decimal and without a unit";

Wanted wantedAfter(const SyntaxStop& stop)
{
    using After = SyntaxStop::After;
    const std::string_view text = stop.text;
    const bool in_object = stop.container && stop.container->kind == Node::Kind::object;
    const auto skip = [&](std::size_t offset) { return offset + spaceLength(text, offset); };
    const std::size_t at = skip(stop.offset);
    switch (stop.after) {
    case After::nothing: return {at, "a value", "a document begins with '{'"};
    case After::opening:
        return in_object ? Wanted{at, "a key or '}'", kPairs}
                         : Wanted{at, "a value or ']'", kValue};
    case After::key:
        if (charAt(text, at) == ':') return {skip(at + 1), "a value", kValue};
        return {at, "':'", "write ':' between a key and its value"};
    case After::value: break;
    }
    if (!stop.container)
        return {at, "the end of the text", "a text holds one value, an object within braces"};
    if (charAt(text, at) == ',')
        return in_object ? Wanted{skip(at + 1), "a key", kPairs}
                         : Wanted{skip(at + 1), "a value", kValue};
    return in_object ? Wanted{at, "',' or '}'", "is a comma missing before it? or close with '}'"}
                     : Wanted{at, "',' or ']'", "is a comma missing before it? or close with ']'"};
}

// What is wrong with the string at `begin`, which the byte at `stop.bad` breaks.
Diagnostic stringFault(const SyntaxStop& stop, std::size_t begin)
{
    const std::string_view text = stop.text;
    const std::size_t bad = stop.bad;
    const char c = charAt(text, bad);
    if (bad >= text.size() || c == '\n' || c == '\r')
        return {Code::syntax, "found a string that does not end on its line",
                "close it with '\"'; a line break in a string is written \\n",
                placeAt(stop.source, begin, std::min(bad, text.size()) - begin)};
    const std::size_t escape = text[bad - 1] == '\\' ? bad - 1 : bad;
    const std::size_t length = bad + 1 - escape;
    return {Code::syntax,
            "found " + quotedToken(printableLine(text.substr(escape, length))) + " in a string",
            "a backslash is written \\\\, a quote \\\", a tab \\t, a line break \\n",
            placeAt(stop.source, escape, length)};
}

Diagnostic faultAt(const SyntaxStop& stop, const Wanted& wanted)
{
    const std::string_view text = stop.text;
    const auto belongs = [&](std::size_t at) {
        return isWordCharacter(charAt(text, at)) || isOneOf(charAt(text, at), "+-.");
    };
    std::size_t begin = wanted.offset, end = wanted.offset;
    if (charAt(text, begin) == '"') {
        if (stop.bad > 0) return stringFault(stop, begin);
        end += stringLength(text, begin);
    } else if (belongs(begin)) {
        while (begin > 0 && belongs(begin - 1)) --begin;  // the parser stopped inside of 01
        while (belongs(end)) ++end;
    } else {
        end += std::max<std::size_t>(utf8Length(text, begin), 1);
    }
    const std::string_view token = text.substr(begin, end - begin);
    const Place place = placeAt(stop.source, begin, token.size());
    const bool value = stop.after == SyntaxStop::After::nothing || wanted.help == kValue;
    const bool number = isDigit(charAt(token, token[0] == '-')) && isDigit(token.back());
    if (value && number && std::isinf(parseNumber(token).value_or(0)))
        return {Code::number_range, "the number " + quotedToken(token) + " is too large",
                "the largest number is about 1.8e308", place};
    return {Code::syntax,
            "found " + quotedToken(printableLine(token)) + " where " + wanted.what + " was wanted",
            wanted.help, place};
}

Diagnostic endFault(const SyntaxStop& stop, const Wanted& wanted)
{
    const Place place = placeAt(stop.source, stop.text.find_last_not_of(" \t\r\n"));
    if (!stop.container)
        return {Code::syntax,
                std::string("the text ends where ") + wanted.what + " was wanted",
                {},
                place};
    return {Code::syntax, std::string("the text ends inside an ") + kindName(stop.container->kind),
            stop.container->kind == Node::Kind::object ? "close it with '}'" : "close it with ']'",
            place};
}

}  // namespace

Diagnostic explainSyntax(const SyntaxStop& stop)
{
    const Wanted wanted = wantedAfter(stop);
    const bool at_end = wanted.offset >= stop.text.size();
    Diagnostic diagnostic = at_end ? endFault(stop, wanted) : faultAt(stop, wanted);
    if (stop.container && (at_end || isOneOf(stop.text[wanted.offset], "]}")))
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

}  // namespace crevice
