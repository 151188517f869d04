// SPDX-License-Identifier: MIT
// Numbers to text and back, by exact decimals, which know no locale.
#include "core/base/numbers.h"

#include "core/base/decimal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

namespace {

// integer * 2^exponent, as a value is stored; its sign is left out.
struct Binary {
    std::uint64_t integer;
    int exponent;
    bool wide;  // the neighbour below is half as far as the one above
};

template <class T>
Binary binaryOf(T value)
{
    using Limits = std::numeric_limits<T>;
    constexpr int kLeast = Limits::min_exponent - Limits::digits;
    int exponent = 0;
    const bool power_of_two = std::frexp(std::abs(value), &exponent) == T(0.5);
    exponent = std::max(exponent - Limits::digits, kLeast);
    const T integer = std::ldexp(std::abs(value), -exponent);
    return {static_cast<std::uint64_t>(integer), exponent, power_of_two && exponent > kLeast};
}

Decimal decimalOf(double value)
{
    const Binary binary = binaryOf(value);
    return Decimal::exact(binary.integer, binary.exponent);
}

std::string digitsText(const Decimal& value, int first, int end)
{
    std::string text;
    for (int i = first; i < end; ++i)
        text += static_cast<char>('0' + (i < 0 ? 0 : value.digitAt(static_cast<std::size_t>(i))));
    return text;
}

// With the point that `decimals` digits follow, if any do.
std::string pointed(const Decimal& value, int point, int decimals)
{
    const std::string whole = point > 0 ? digitsText(value, 0, point) : "0";
    return decimals > 0 ? whole + "." + digitsText(value, point, point + decimals) : whole;
}

int sizeOf(const Decimal& value) { return static_cast<int>(value.digits.size()); }

std::string fixedText(const Decimal& value, int decimals)
{
    return pointed(value, value.point, decimals);
}

std::string fixedText(const Decimal& value)
{
    return fixedText(value, sizeOf(value) - value.point);
}

std::string scientificText(const Decimal& value, int decimals)
{
    const int exponent = value.digits.empty() ? 0 : value.point - 1;
    const std::string text = std::to_string(std::abs(exponent));
    return pointed(value, 1, decimals) + (exponent < 0 ? "e-" : "e+") +
           (text.size() < 2 ? "0" : "") + text;
}

std::string scientificText(const Decimal& value)
{
    return scientificText(value, sizeOf(value) - 1);
}

// The sign, and what `write` makes of a finite value.
template <class Write>
std::string written(double value, Write write)
{
    const std::string sign = std::signbit(value) ? "-" : "";
    if (std::isnan(value)) return sign + "nan";
    return sign + (std::isinf(value) ? "inf" : write());
}

// Whichever of the two forms is shorter. Whole numbers have all their digits in the first.
template <class T>
std::string shortestOf(T value)
{
    return written(value, [&] {
        if (value == 0) return std::string("0");
        const Binary binary = binaryOf(value);
        const Decimal decimal = shortestDecimal(binary.integer, binary.exponent, binary.wide);
        const bool whole = sizeOf(decimal) <= decimal.point;
        const std::string plain = fixedText(whole ? decimalOf(value) : decimal);
        const std::string scientific = scientificText(decimal);
        return plain.size() <= scientific.size() ? plain : scientific;
    });
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Cuts off the digits that `text` begins with.
std::string_view takeDigits(std::string_view& text)
{
    const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

// Cuts off an exponent, if there is a whole one; one of more digits than any double has is cut
// short.
int takeExponent(std::string_view& text)
{
    if (text.empty() || (text[0] != 'e' && text[0] != 'E')) return 0;
    std::string_view rest = text.substr(1);
    const bool negative = !rest.empty() && rest[0] == '-';
    if (negative || (!rest.empty() && rest[0] == '+')) rest.remove_prefix(1);
    const std::string_view digits = takeDigits(rest);
    if (digits.empty()) return 0;
    text = rest;
    int exponent = 0;
    constexpr int kEnough = 100'000'000;
    for (const char digit : digits) exponent = std::min(exponent * 10 + (digit - '0'), kEnough);
    return negative ? -exponent : exponent;
}

// Cuts off "inf", "infinity" or "nan", in letters of any size.
std::optional<double> takeWord(std::string_view& text)
{
    using Limits = std::numeric_limits<double>;
    const std::pair<std::string_view, double> words[] = {{"infinity", Limits::infinity()},
                                                         {"inf", Limits::infinity()},
                                                         {"nan", Limits::quiet_NaN()}};
    for (const auto& [word, value] : words) {
        const auto same = [](char a, char b) { return a == (b | 0x20); };
        if (text.size() < word.size() || !std::equal(word.begin(), word.end(), text.begin(), same))
            continue;
        text.remove_prefix(word.size());
        return value;
    }
    return std::nullopt;
}

std::optional<double> takeUnsigned(std::string_view& text)
{
    std::string_view rest = text;
    const std::string_view whole = takeDigits(rest);
    std::string_view fraction;
    if (!rest.empty() && rest[0] == '.') {
        std::string_view after = rest.substr(1);
        fraction = takeDigits(after);
        if (!whole.empty() || !fraction.empty()) rest = after;
    }
    if (whole.empty() && fraction.empty()) return takeWord(text);
    Decimal value{std::string(whole) + std::string(fraction), static_cast<int>(whole.size())};
    value.point += takeExponent(rest);
    value.trim();
    text = rest;
    return value.toDouble();
}

}  // namespace

std::string shortest(float value) { return shortestOf(value); }

std::string shortest(double value) { return shortestOf(value); }

std::string fixed(double value, int decimals)
{
    return written(value, [&] {
        const Decimal decimal = decimalOf(value);
        return fixedText(decimal.rounded(decimal.point + decimals), decimals);
    });
}

std::string significant(double value, int digits)
{
    return written(value, [&] {
        const Decimal decimal = decimalOf(value).rounded(std::max(digits, 1));
        const bool plain = decimal.point > -4 && decimal.point <= std::max(digits, 1);
        return plain ? fixedText(decimal) : scientificText(decimal);
    });
}

std::string scientific(double value, int decimals)
{
    return written(
        value, [&] { return scientificText(decimalOf(value).rounded(decimals + 1), decimals); });
}

std::optional<double> takeNumber(std::string_view& text)
{
    std::string_view rest = text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const bool negative = !rest.empty() && rest[0] == '-';
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
