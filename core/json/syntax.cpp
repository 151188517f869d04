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

Wanted wantedAfter(std::string_view text, const SyntaxStop& stop)
{
    using After = SyntaxStop::After;
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

// What is wrong with the string at `begin`, which the byte at `bad` breaks.
Fault stringFault(std::string_view text, std::size_t begin, std::size_t bad)
{
    const char c = charAt(text, bad);
    if (bad >= text.size() || c == '\n' || c == '\r')
        return {begin, std::min(bad, text.size()) - begin,
                "found a string that does not end on its line",
                "close it with '\"'; a line break in a string is written \\n"};
    const std::size_t escape = text[bad - 1] == '\\' ? bad - 1 : bad;
    return {
        escape, bad + 1 - escape,
        "found " + quoted(printableLine(text.substr(escape, bad + 1 - escape))) + " in a string",
        "a backslash is written \\\\, a quote \\\", a tab \\t, a line break \\n"};
}

Fault faultAt(std::string_view text, const SyntaxStop& stop, const Wanted& wanted)
{
    const auto belongs = [&](std::size_t at) {
        return isWordCharacter(charAt(text, at)) || isOneOf(charAt(text, at), "+-.");
    };
    std::size_t begin = wanted.offset, end = wanted.offset;
    if (charAt(text, begin) == '"') {
        if (stop.bad > 0) return stringFault(text, begin, stop.bad);
        end += stringLength(text, begin);
    } else if (belongs(begin)) {
        while (begin > 0 && belongs(begin - 1)) --begin;  // the parser stopped inside of 01
        while (belongs(end)) ++end;
    } else {
        end += std::max<std::size_t>(utf8Length(text, begin), 1);
    }
    const std::string_view token = text.substr(begin, end - begin);
    if ((stop.after == SyntaxStop::After::nothing || wanted.help == kValue) &&
        numberLength(token, 0) == token.size())
        return {begin, token.size(), "the number " + quoted(token) + " is too large",
                "the largest number is about 1.8e308", Code::number_range};
    return {begin, token.size(),
            "found " + quoted(printableLine(token)) + " where " + wanted.what + " was wanted",
            wanted.help};
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
