// SPDX-License-Identifier: MIT
// Small helpers for text, numbers and lists that messages and documents share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crevice {

// Of ASCII, whatever the locale is.
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isLower(char c) { return c >= 'a' && c <= 'z'; }
inline bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }

/// What an identifier of GLSL may begin with, and what it may go on with.
inline bool isWordStart(char c) { return isLower(c) || isUpper(c) || c == '_'; }
inline bool isWord(char c) { return isWordStart(c) || isDigit(c); }

/// Where `word` stands in the text as a word of its own, from `begin` on; npos where nowhere.
std::size_t findWord(std::string_view text, std::string_view word, std::size_t begin = 0);

bool startsWith(std::string_view text, std::string_view start);
bool endsWith(std::string_view text, std::string_view end);
bool has(std::string_view text, std::string_view part);

/// Bytes of the UTF-8 character that begins at `at`, 1 to 4; 0 when the bytes there are none
/// (overlong forms, surrogates and code points above U+10FFFF included). Requires at < text.size().
std::size_t utf8Length(std::string_view text, std::size_t at);

/// The code point of that character; U+FFFD when the bytes are none.
std::uint32_t codePoint(std::string_view text, std::size_t at);

/// The first `bytes` of `text`, fewer where a character would be cut in two.
std::string_view utf8Prefix(std::string_view text, std::size_t bytes);

/// The line of that number, from 1, without its end; empty where there is none.
std::string_view lineOf(std::string_view text, int line);

/// ASCII letters in upper case: a param `blur_size` is the define BLUR_SIZE.
std::string upperCase(std::string_view text);

/// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

/// What lies between the separators, from left to right; parts may be empty.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Without what `blanks` has of its characters at either end.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t");

bool contains(const std::vector<std::string>& words, std::string_view word);

/// The words with `separator` between them.
std::string joined(const std::vector<std::string>& words, std::string_view separator = ", ");

/// "'×' (U+00D7)" for the character at `at`. Requires at < text.size().
std::string characterName(std::string_view text, std::size_t at);

/// True for the character at `at` when a terminal obeys it instead of showing it: control
/// characters, and marks that turn the direction of writing. Requires at < text.size().
bool isControl(std::string_view text, std::size_t at);

/// `text` for a terminal: what isControl finds, but line feeds and tabs, is written out as
/// "\u001b", and bytes that are not UTF-8 become U+FFFD. JSON stays the same JSON.
std::string printable(std::string_view text);

/// The same with line feeds and tabs written out too: for a name, or a message of one line.
std::string printableLine(std::string_view text);

/// `text` as a JSON string in double quotes, printable. Bytes that are not UTF-8 become U+FFFD.
std::string jsonString(std::string_view text);

/// The RFC 6901 pointer of a member: "/passes" and "a/b" give "/passes/a~1b".
std::string memberPointer(std::string_view parent, std::string_view key);

/// The keys of an RFC 6901 pointer, empty or with a '/' first: "/passes/a~1b" has "passes", "a/b".
std::vector<std::string> pointerKeys(std::string_view pointer);

// Numbers to text and back, whatever the locale is. The only place that does so: printf, strtod and
// streams write and read a decimal comma once the host has called setlocale, as every Qt and GTK
// program does, and libc++ 13 (Emscripten, iOS, Android) has no <charconv> of floats. What is not
// finite becomes "nan", "inf" or "-inf".

/// The fewest digits that read back as the same number, of a power of two at most one more: "0.5".
std::string shortest(float value);
std::string shortest(double value);

/// With that many decimals, as printf's %.3f: "0.500".
std::string fixed(double value, int decimals);

/// With at most that many digits and no zeros at the end, as printf's %.4g: "0.5", "1.235e-07".
std::string significant(double value, int digits);

/// With that many decimals and an exponent, as printf's %.3e: "5.000e-01".
std::string scientific(double value, int decimals);

/// The number that `text` begins with, which is then cut off it: "90s" gives 90 and leaves "s".
/// Spaces before it are skipped; one too large for a double is infinite. Nothing where none is.
std::optional<double> takeNumber(std::string_view& text);

/// The number that the whole of `text` is: "0.5", "-1e3", "inf".
std::optional<double> parseNumber(std::string_view text);

// Questions to a whole list: a vector, an array, a map.

template <class List, class Test>
bool anyOf(const List& list, Test test)
{
    return std::any_of(std::begin(list), std::end(list), test);
}

template <class List, class Test>
bool allOf(const List& list, Test test)
{
    return std::all_of(std::begin(list), std::end(list), test);
}

template <class List, class Test>
void eraseIf(List& list, Test test)
{
    list.erase(std::remove_if(list.begin(), list.end(), test), list.end());
}

}  // namespace crevice
