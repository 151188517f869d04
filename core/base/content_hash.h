// SPDX-License-Identifier: MIT
// A hash over content, for keys that are the same on every machine and run. No one attacks it.
//
// Source: Fowler et al. 1991, the 64-bit FNV-1a.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

namespace crevice {

class ContentHash {
public:
    void addBytes(const void* data, std::size_t size)
    {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t k = 0; k < size; ++k) value_ = (value_ ^ bytes[k]) * 1099511628211ull;
    }

    /// A plain number.
    template <class T>
    void add(T number)
    {
        static_assert(std::is_arithmetic_v<T>, "padding would be hashed with anything else");
        addBytes(&number, sizeof(number));
    }

    /// Text with its length, so that "ab", "c" is not "a", "bc".
    void addText(std::string_view text)
    {
        add(static_cast<std::uint64_t>(text.size()));
        addBytes(text.data(), text.size());
    }

    std::uint64_t value() const { return value_; }

    /// 16 hex digits.
    std::string hex() const
    {
        char digits[17];
        std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(value_));
        return digits;
    }

private:
    std::uint64_t value_ = 14695981039346656037ull;
};

}  // namespace crevice
