// SPDX-License-Identifier: MIT
// Numbers to text and back by printf and strtod, with the locale's decimal point made a point.
#include "core/base/numbers.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace crevice {

namespace {

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
