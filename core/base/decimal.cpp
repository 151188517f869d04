// SPDX-License-Identifier: MIT
#include "core/base/decimal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

namespace {

constexpr int kMostBits = 59;  // of one step: ten times 2^59 fits 64 bits

// Digits of the largest double before its point, and of what is 0 after it.
constexpr int kLargestPoint = 310;
constexpr int kSmallestPoint = -330;

void multiply(Decimal& value, int bits)
{
    std::uint64_t carry = 0;
    for (auto digit = value.digits.rbegin(); digit != value.digits.rend(); ++digit) {
        carry += static_cast<std::uint64_t>(*digit - '0') << bits;
        *digit = static_cast<char>('0' + carry % 10);
        carry /= 10;
    }
    if (carry == 0) return;
    const std::string front = std::to_string(carry);
    value.digits.insert(0, front);
    value.point += static_cast<int>(front.size());
}

void divide(Decimal& value, int bits)
{
    const std::uint64_t mask = (std::uint64_t(1) << bits) - 1;
    std::uint64_t rest = 0;
    std::string quotient;
    for (std::size_t i = 0; i < value.digits.size() || rest != 0; ++i) {
        rest = rest * 10 + value.digitAt(i);
        quotient += static_cast<char>('0' + (rest >> bits));
        rest &= mask;
    }
    value.digits = std::move(quotient);
}

// Bits that bring a number of that point nearer to 1, and not past it.
int bitsTowardsOne(int point) { return std::clamp(3 * (point - 1), 1, kMostBits); }

// Scales into [0.5, 1): `value` times 2^ what is returned is what it was.
int normalise(Decimal& value)
{
    int exponent = 0;
    const auto shift = [&](int bits) {
        value.shift(bits);
        exponent -= bits;
    };
    while (value.point > 0) shift(-bitsTowardsOne(value.point));
    while (value.point < 0 || value.digits[0] < '5') shift(bitsTowardsOne(1 - value.point));
    return exponent;
}

std::uint64_t integerOf(const Decimal& value)
{
    std::uint64_t integer = 0;
    for (int i = 0; i < value.point; ++i) integer = integer * 10 + value.digitAt(i);
    return integer;
}

}  // namespace

Decimal Decimal::exact(std::uint64_t integer, int exponent)
{
    Decimal value;
    value.digits = std::to_string(integer);
    value.point = static_cast<int>(value.digits.size());
    value.trim();
    value.shift(exponent);
    return value;
}

void Decimal::trim()
{
    const std::size_t zeros = std::min(digits.find_first_not_of('0'), digits.size());
    digits.erase(0, zeros);
    digits.erase(digits.find_last_not_of('0') + 1);
    point = digits.empty() ? 0 : point - static_cast<int>(zeros);
}

void Decimal::shift(int bits)
{
    for (; bits > 0; bits -= std::min(bits, kMostBits)) multiply(*this, std::min(bits, kMostBits));
    for (; bits < 0; bits += std::min(-bits, kMostBits)) divide(*this, std::min(-bits, kMostBits));
    trim();
}

Decimal Decimal::rounded(int kept, bool upwards) const
{
    if (kept >= static_cast<int>(digits.size())) return *this;
    if (kept < 0) return {};
    Decimal value = *this;
    value.digits.resize(static_cast<std::size_t>(kept));
    const bool odd = kept > 0 && (digits[kept - 1] - '0') % 2 == 1;
    const int half = digits.compare(static_cast<std::size_t>(kept), digits.npos, "5");
    if (upwards || half > 0 || (half == 0 && odd)) {
        const std::size_t nine = value.digits.find_last_not_of('9');
        if (nine == value.digits.npos) {
            value.digits = "1";
            ++value.point;
        } else {
            value.digits.resize(nine + 1);
            ++value.digits[nine];
        }
    }
    value.trim();
    return value;
}

double Decimal::toDouble() const
{
    using Limits = std::numeric_limits<double>;
    if (digits.empty() || point < kSmallestPoint) return 0.0;
    if (point > kLargestPoint) return Limits::infinity();
    Decimal value = *this;
    const int exponent = normalise(value);
    const int bits = std::min(Limits::digits, exponent - Limits::min_exponent + Limits::digits);
    if (bits < 0) return 0.0;
    value.shift(bits);
    value = value.rounded(value.point);
    return std::ldexp(static_cast<double>(integerOf(value)), exponent - bits);
}

int compared(const Decimal& a, const Decimal& b)
{
    if (a.digits.empty() || b.digits.empty() || a.point == b.point)
        return a.digits.compare(b.digits);
    return a.point - b.point;
}

Decimal shortestDecimal(std::uint64_t integer, int exponent, bool wide)
{
    const Decimal value = Decimal::exact(integer, exponent);
    const Decimal above = Decimal::exact(2 * integer + 1, exponent - 1);
    const Decimal below = wide ? Decimal::exact(4 * integer - 1, exponent - 2)
                               : Decimal::exact(2 * integer - 1, exponent - 1);
    const int allowed =
        integer % 2 == 0 ? 0 : -1;  // the middles themselves are read as the even one
    const auto holds = [&](const Decimal& candidate) {
        return compared(below, candidate) <= allowed && compared(candidate, above) <= allowed;
    };
    for (int kept = 1;; ++kept)
        for (const bool upwards : {false, true})
            if (Decimal candidate = value.rounded(kept, upwards); holds(candidate))
                return candidate;
}

}  // namespace crevice
