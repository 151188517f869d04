// SPDX-License-Identifier: MIT
// Numbers to text and back, by <charconv>, which knows no locale.
#include "core/base/numbers.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace crevice {

namespace {

// The longest text of a double: all digits before the point of the largest, and `decimals` after.
constexpr int kMostDigits = 320;

template <class T, class... Format>
std::string written(T value, int decimals, Format... format)
{
    std::string text(static_cast<std::size_t>(kMostDigits + decimals), '\0');
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format...);
    text.resize(static_cast<std::size_t>(end.ptr - text.data()));
    return text;
}

// Infinite for a number that is too large, 0 for one that is too small.
double beyondDouble(const std::string& text)
{
    const std::size_t exponent = text.find_first_of("eE");
    const bool small = exponent != text.npos ? text[exponent + 1] == '-'
                                             : text.find_first_of("123456789") > text.find('.');
    const double value = small ? 0.0 : std::numeric_limits<double>::infinity();
    return text[0] == '-' ? -value : value;
}

}  // namespace

std::string shortest(float value) { return written(value, 0); }

std::string shortest(double value) { return written(value, 0); }

std::string fixed(double value, int decimals)
{
    return written(value, decimals, std::chars_format::fixed, decimals);
}

std::string significant(double value, int digits)
{
    return written(value, digits, std::chars_format::general, digits);
}

std::string scientific(double value, int decimals)
{
    return written(value, decimals, std::chars_format::scientific, decimals);
}

std::optional<double> takeNumber(std::string_view& text)
{
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const char* const first = text.data() + begin;
    const char* const last = text.data() + text.size();
    double value = 0;
    const auto read = std::from_chars(first, last, value);
    if (read.ec == std::errc::invalid_argument) return std::nullopt;
    if (read.ec == std::errc::result_out_of_range) value = beyondDouble({first, read.ptr});
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    return value;
}

std::optional<double> parseNumber(std::string_view text)
{
    const std::optional<double> value = takeNumber(text);
    return text.empty() ? value : std::nullopt;
}

}  // namespace crevice
