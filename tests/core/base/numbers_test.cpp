// SPDX-License-Identifier: MIT
// Numbers as text, held against the standard library's <charconv>, where it has the floating-point
// half.
#include "core/base/text.h"

#include "tests/support/catch.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <random>

#ifdef __cpp_lib_to_chars

using namespace crevice;

namespace {

template <class T, class... Format>
std::string standard(T value, Format... format)
{
    char text[1000];
    const auto end = std::to_chars(text, text + sizeof(text), value, format...);
    return {text, end.ptr};
}

template <class T, class Bits>
T fromBits(Bits bits)
{
    static_assert(sizeof(T) == sizeof(Bits));
    T value;
    std::memcpy(&value, &bits, sizeof(T));
    return value;
}

/// Powers of two and their neighbours, any bits at all, and what people write.
std::vector<double> manyNumbers()
{
    std::vector<double> numbers = {0.0, -0.0, HUGE_VAL, -HUGE_VAL, 1e22, 1e23, 123456789.0, 0.3};
    for (int exponent = -1075; exponent < 1024; exponent += 7)
        for (const double beside : {0.0, 1.0, HUGE_VAL})
            numbers.push_back(std::nextafter(std::ldexp(1.0, exponent), beside));
    std::mt19937_64 random(1);
    for (int i = 0; i < 2000; ++i) {
        numbers.push_back(fromBits<double>(random()));
        numbers.push_back(static_cast<double>(random() % 1000000) * 1e-3);
        numbers.push_back(std::ldexp(static_cast<double>(random()), -static_cast<int>(i % 80)));
    }
    return numbers;
}

std::optional<double> standardTake(std::string_view& text)
{
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec == std::errc::invalid_argument) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end.ptr - text.data()));
    return value;
}

/// A power of two may have one digit more: fewer lie nearer to the number above it.
template <class T>
bool isShortest(T value)
{
    const std::string text = shortest(value), least = standard(value);
    int exponent = 0;
    const bool power_of_two = std::frexp(std::abs(value), &exponent) == T(0.5);
    return text == least || (power_of_two && static_cast<T>(*parseNumber(text)) == value &&
                             text.size() == least.size() + 1);
}

}  // namespace

TEST_CASE("Numbers are written as <charconv> writes them")
{
    for (const double value : manyNumbers()) {
        if (std::isnan(value)) continue;
        INFO(standard(value));
        REQUIRE(isShortest(value));
        REQUIRE(isShortest(static_cast<float>(value)));
        for (const int digits : {0, 3, 17}) {
            using std::chars_format;
            REQUIRE(fixed(value, digits) == standard(value, chars_format::fixed, digits));
            REQUIRE(significant(value, digits) == standard(value, chars_format::general, digits));
            REQUIRE(scientific(value, digits) == standard(value, chars_format::scientific, digits));
        }
    }
}

TEST_CASE("Numbers are read as <charconv> reads them")
{
    for (const double value : manyNumbers()) {
        if (std::isnan(value)) continue;
        using std::chars_format;
        for (const std::string& text :
             {standard(value), standard(value, chars_format::scientific, 20)}) {
            INFO(text);
            REQUIRE(parseNumber(text) == value);
        }
    }
    const char* const odd =
        "1.|1.e5|.5|.|-|.e5|1e|1e+|1e-x|infx|-INFINITY|+1|0x10|000123|0.000e5|--1|1e5.5||"
        "0e99999999999|9007199254740993|9007199254740992.99999999999999999999|"
        "2.4703282292062327e-324|2.4703282292062329e-324|1.7976931348623158e308";
    for (const std::string_view text : split(odd, '|')) {
        INFO(text);
        std::string_view ours = text, theirs = text;
        const std::optional<double> expected = standardTake(theirs);
        CHECK(takeNumber(ours) == expected);
        CHECK(ours == theirs);
    }
}

#endif
