// SPDX-License-Identifier: MIT
// UTF-8, JSON strings and pointers; numbers by printf and strtod, with the locale's decimal point
// made a point.
#include "core/base/text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace crevice {
namespace {

unsigned char byteAt(std::string_view text, std::size_t at)
{
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

struct Character {
    std::size_t length = 0;  // bytes; 0 where there is none
    std::uint32_t code = 0xFFFD;
};

// The character at `at`.
Character characterAt(std::string_view text, std::size_t at)
{
    const unsigned char first = byteAt(text, at);
    if (first < 0x80) return {1, first};
    if (first < 0xC0 || first > 0xF7) return {};
    const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    std::uint32_t code = first & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        const unsigned char byte = byteAt(text, at + i);
        if ((byte & 0xC0) != 0x80) return {};
        code = code << 6 | (byte & 0x3Fu);
    }
    constexpr std::uint32_t kLeast[] = {0x80, 0x800, 0x10000};  // else there is a shorter form
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    if (code < kLeast[length - 2] || code > 0x10FFFF || surrogate) return {};
    return {length, code};
}

// C0, DEL, C1, and what turns or ends a line (Unicode 15, "Bidi_Control" and U+2028, U+2029).
constexpr std::uint32_t kControls[][2] = {{0, 0x1F},        {0x7F, 0x9F},     {0x61C, 0x61C},
                                          {0x200E, 0x200F}, {0x2028, 0x202E}, {0x2066, 0x2069}};

// All of them are within the 16 bits that JSON writes so.
void appendEscaped(std::string& out, std::uint32_t code)
{
    static const char kDigits[] = "0123456789abcdef";
    out += "\\u";
    for (int shift = 12; shift >= 0; shift -= 4) out += kDigits[code >> shift & 15];
}

std::string printableBut(std::string_view kept, std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = utf8Length(text, at);
        if (length == 0)
            out += "\xEF\xBF\xBD";
        else if (isControl(text, at) && kept.find(text[at]) == kept.npos)
            appendEscaped(out, codePoint(text, at));
        else
            out += text.substr(at, length);
        at += std::max<std::size_t>(length, 1);
    }
    return out;
}

std::string withCase(std::string_view text, bool (*is_other)(char), int offset)
{
    std::string changed(text);
    for (char& c : changed)
        if (is_other(c)) c = static_cast<char>(c + offset);
    return changed;
}

// What follows the backslash.
char shortEscape(char c) { return c == '\n' ? 'n' : c == '\r' ? 'r' : c == '\t' ? 't' : c; }

// What printf writes now between 0 and 5. localeconv says so too, but not to several threads.
std::string localPoint()
{
    char text[16];
    const int size = std::snprintf(text, sizeof(text), "%.1f", 0.5);
    return std::string(text + 1, static_cast<std::size_t>(size) - 2);
}

void replacePoint(std::string& text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    if (at != text.npos) text.replace(at, from.size(), to);
}

// As printf writes a finite number in this format.
std::string printed(const char* format, int precision, double value)
{
    if (!std::isfinite(value))
        return std::string(std::signbit(value) ? "-" : "") + (std::isnan(value) ? "nan" : "inf");
    const int size = std::snprintf(nullptr, 0, format, precision, value);
    std::string text(static_cast<std::size_t>(size), '\0');
    std::snprintf(text.data(), text.size() + 1, format, precision, value);
    replacePoint(text, localPoint(), ".");
    return text;
}

// The fewest digits that read back as the same number, as 1.5e+00.
template <class T>
std::string fewestDigits(T value)
{
    std::string text;
    for (int decimals = 0; decimals < std::numeric_limits<T>::max_digits10; ++decimals) {
        text = printed("%.*e", decimals, value);
        if (static_cast<T>(*parseNumber(text)) == value) break;
    }
    return text;
}

// Whichever of the two forms is shorter. Whole numbers have all their digits in the first.
template <class T>
std::string shortestOf(T value)
{
    if (!std::isfinite(value) || value == 0) return printed("%.*f", 0, value);
    const std::string scientific = fewestDigits(value);
    const std::size_t e = scientific.find('e');
    const std::size_t point = scientific.find('.');
    const int digits = point < e ? static_cast<int>(e - point) : 1;
    const int exponent = std::atoi(scientific.c_str() + e + 1);
    const std::string plain = printed("%.*f", std::max(digits - 1 - exponent, 0), value);
    return plain.size() <= scientific.size() ? plain : scientific;
}

// Cuts "infinity", "inf" or "nan" off, in letters of any size.
std::optional<double> takeWord(std::string_view& text)
{
    using Limits = std::numeric_limits<double>;
    const std::string lower = lowerCase(text.substr(0, 8));
    for (const std::string_view word : {"infinity", "inf", "nan"}) {
        if (!startsWith(lower, word)) continue;
        text.remove_prefix(word.size());
        return word == "nan" ? Limits::quiet_NaN() : Limits::infinity();
    }
    return std::nullopt;
}

std::optional<double> takeUnsigned(std::string_view& text)
{
    if (text.empty() || !(isDigit(text[0]) || text[0] == '.')) return takeWord(text);
    const std::string point = localPoint();
    std::string number(text.substr(0, text.find_first_not_of("0123456789.eE+-")));  // no 0x1p4
    replacePoint(number, ".", point);
    char* end = nullptr;
    const double value = std::strtod(number.c_str(), &end);
    number.resize(static_cast<std::size_t>(end - number.c_str()));
    if (number.empty()) return std::nullopt;
    replacePoint(number, point, ".");
    text.remove_prefix(number.size());
    return value;
}

}  // namespace

std::size_t findWord(std::string_view text, std::string_view word, std::size_t begin)
{
    for (auto at = text.find(word, begin); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool starts = at == 0 || !isWord(text[at - 1]);
        if (starts && (end == text.size() || !isWord(text[end]))) return at;
    }
    return text.npos;
}

bool startsWith(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

bool endsWith(std::string_view text, std::string_view end)
{
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool has(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

std::size_t utf8Length(std::string_view text, std::size_t at)
{
    return characterAt(text, at).length;
}

std::uint32_t codePoint(std::string_view text, std::size_t at)
{
    return characterAt(text, at).code;
}

std::string_view utf8Prefix(std::string_view text, std::size_t bytes)
{
    std::size_t end = std::min(bytes, text.size());
    while (end > 0 && end < text.size() && (byteAt(text, end) & 0xC0) == 0x80) --end;
    return text.substr(0, end);
}

bool isControl(std::string_view text, std::size_t at)
{
    const std::uint32_t code = codePoint(text, at);
    return anyOf(kControls,
                 [code](const auto& range) { return code >= range[0] && code <= range[1]; });
}

std::string printable(std::string_view text) { return printableBut("\n\t", text); }

std::string printableLine(std::string_view text) { return printableBut("", text); }

std::string characterName(std::string_view text, std::size_t at)
{
    char code[16];
    std::snprintf(code, sizeof(code), "' (U+%04X)", unsigned(characterAt(text, at).code));
    return "'" + printableLine(text.substr(at, std::max<std::size_t>(utf8Length(text, at), 1))) +
           code;
}

std::string jsonString(std::string_view text)
{
    std::string out = "\"";
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\"\\\n\r\t", begin), text.size());
        out += printableLine(text.substr(begin, end - begin));
        if (end < text.size()) out += {'\\', shortEscape(text[end])};
        begin = end + 1;
    }
    return out + '"';
}

std::string_view lineOf(std::string_view text, int line)
{
    for (int at = 1; at < line; ++at) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    return text;
}

std::string upperCase(std::string_view text) { return withCase(text, isLower, 'A' - 'a'); }

std::string lowerCase(std::string_view text) { return withCase(text, isUpper, 'a' - 'A'); }

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(separator, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

std::string_view trimmed(std::string_view text, std::string_view blanks)
{
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

bool contains(const std::vector<std::string>& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string joined(const std::vector<std::string>& words, std::string_view separator)
{
    std::string text;
    for (const std::string& word : words) {
        if (!text.empty()) text += separator;
        text += word;
    }
    return text;
}

std::string memberPointer(std::string_view parent, std::string_view key)
{
    std::string pointer(parent);
    pointer += '/';
    for (const char c : key)
        if (c == '~' || c == '/')
            pointer += c == '~' ? "~0" : "~1";
        else
            pointer += c;
    return pointer;
}

std::vector<std::string> pointerKeys(std::string_view pointer)
{
    std::vector<std::string> keys;
    for (std::size_t at = 0; at < pointer.size(); ++at) {
        const std::string_view escape = pointer.substr(at, 2);
        if (pointer[at] == '/')
            keys.emplace_back();
        else if (escape == "~0" || escape == "~1")
            keys.back() += pointer[++at] == '0' ? '~' : '/';
        else
            keys.back() += pointer[at];
    }
    return keys;
}

std::string shortest(float value) { return shortestOf(value); }

std::string shortest(double value) { return shortestOf(value); }

std::string fixed(double value, int decimals) { return printed("%.*f", decimals, value); }

std::string significant(double value, int digits) { return printed("%.*g", digits, value); }

std::string scientific(double value, int decimals) { return printed("%.*e", decimals, value); }

std::optional<double> takeNumber(std::string_view& text)
{
    std::string_view rest = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const bool negative = startsWith(rest, "-");
    if (negative) rest.remove_prefix(1);
    const std::optional<double> value = takeUnsigned(rest);
    if (!value) return std::nullopt;
    text = rest;
    return negative ? -*value : *value;
}

std::optional<double> parseNumber(std::string_view text)
{
    const std::optional<double> value = takeNumber(text);
    return text.empty() ? value : std::nullopt;
}

}  // namespace crevice
