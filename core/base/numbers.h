// SPDX-License-Identifier: MIT
// Numbers to text and back, whatever the locale is. The only place that does so: printf, strtod and
// streams write and read a decimal comma once the host has called setlocale, as every Qt and GTK
// program does, and libc++ 13 (Emscripten, iOS, Android) has no <charconv> of floats.
//
// What is not finite becomes "nan", "inf" or "-inf".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace crevice {

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
/// Spaces before it are skipped; one that is too large for a double is infinite. Nothing where
/// there is none.
std::optional<double> takeNumber(std::string_view& text);

/// The number that the whole of `text` is: "0.5", "-1e3", "inf".
std::optional<double> parseNumber(std::string_view text);

}  // namespace crevice
