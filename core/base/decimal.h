// SPDX-License-Identifier: MIT
// Decimal numbers of any length, exact: what numbers are written from and read into. The
// floating-point half of <charconv> would do the same, but libc++ 13 (Emscripten, iOS, Android)
// lacks it.
#pragma once

#include <cstdint>
#include <string>

namespace crevice {

/// 0 or more: 0.DIGITS * 10^point. Neither the first digit is 0 nor the last; zero has none.
struct Decimal {
    std::string digits;  ///< From '0' to '9'.
    int point = 0;

    /// integer * 2^exponent, with every digit.
    static Decimal exact(std::uint64_t integer, int exponent);

    /// 0 past the last.
    unsigned digitAt(std::size_t i) const
    {
        return i < digits.size() ? static_cast<unsigned>(digits[i] - '0') : 0;
    }

    /// Removes zeros at both ends.
    void trim();

    /// Times 2^bits; bits may be negative.
    void shift(int bits);

    /// To at most `kept` digits: the nearest, the even one of two. With `upwards` the next that is
    /// not less.
    Decimal rounded(int kept, bool upwards = false) const;

    /// The nearest double; infinite where that is too large.
    double toDouble() const;
};

/// Below zero for less, zero for equal, above zero for more.
int compared(const Decimal& a, const Decimal& b);

/// The fewest digits that lie between the middles to the neighbours of integer * 2^exponent; of
/// those the nearest. `wide` where the neighbour below is only half as far as the one above.
Decimal shortestDecimal(std::uint64_t integer, int exponent, bool wide);

}  // namespace crevice
