// SPDX-License-Identifier: MIT
// Bytes of a baked effect. One list of members, `fields` in core/bake/records.h, serves both ways:
// ArchiveWriter writes them, ArchiveReader reads them back and fails on what no writer wrote.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace crevice {

/// Most entries of a list.
constexpr std::uint32_t kMostBaked = 4096;

/// An enum whose words end with `last`.
template <class Enum>
struct EnumField {
    Enum& value;
    Enum last;
};

template <class Enum>
EnumField<Enum> upTo(Enum& value, Enum last)
{
    return {value, last};
}

/// Calls itself for each member in turn.
template <class Derived>
struct ArchiveBase {
    template <class... Members>
    void operator()(Members&&... members)
    {
        (static_cast<Derived*>(this)->member(members), ...);
    }
};

/// Whole numbers, small ones in a byte: seven bits a byte, the lowest first; signs alternate.
class ArchiveWriter : public ArchiveBase<ArchiveWriter> {
public:
    static constexpr bool kReads = false;
    std::string bytes;

    void number(std::uint32_t value)
    {
        for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
        bytes += static_cast<char>(value);
    }
    void member(const int& value)
    {
        const auto bits = static_cast<std::uint32_t>(value);
        number(bits << 1 ^ (value < 0 ? ~0u : 0u));
    }
    void member(const std::uint32_t& value) { number(value); }
    void member(const bool& value) { number(value); }
    void member(const float& value) { raw(value); }
    void member(const double& value) { raw(value); }
    void member(const std::string& text)
    {
        number(static_cast<std::uint32_t>(text.size()));
        bytes += text;
    }
    template <class Enum>
    void member(const EnumField<Enum>& field)
    {
        number(static_cast<std::uint32_t>(field.value));
    }
    void member(const std::array<float, 4>& values)
    {
        for (const float value : values) raw(value);
    }
    template <class T>
    void member(const std::vector<T>& list)
    {
        number(static_cast<std::uint32_t>(list.size()));
        for (const T& each : list) member(each);
    }
    template <class T>
    std::enable_if_t<std::is_class_v<T>> member(const T& record)
    {
        fields(*this, const_cast<T&>(record));
    }

private:
    template <class T>
    void raw(const T& value)
    {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
};

class ArchiveReader : public ArchiveBase<ArchiveReader> {
public:
    static constexpr bool kReads = true;

    explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

    /// Whether all that was read was there and in range.
    bool ok() const { return ok_; }
    bool atEnd() const { return rest_.empty(); }
    void fail()
    {
        ok_ = false;
        rest_ = {};
    }
    void require(bool holds)
    {
        if (!holds) fail();
    }

    std::uint32_t number()
    {
        std::uint32_t value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            if (rest_.empty()) break;
            const auto byte = static_cast<unsigned char>(rest_.front());
            rest_.remove_prefix(1);
            value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
            if (byte < 0x80) return value;
        }
        fail();
        return 0;
    }
    std::string_view take(std::size_t count)
    {
        if (count > rest_.size()) fail(), count = 0;
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    void member(int& value)
    {
        const std::uint32_t bits = number();
        value = static_cast<int>(bits >> 1 ^ (0 - (bits & 1)));
    }
    void member(std::uint32_t& value) { value = number(); }
    void member(bool& value)
    {
        const std::uint32_t read = number();
        require(read < 2);
        value = read == 1;
    }
    void member(float& value) { raw(value); }
    void member(double& value) { raw(value); }
    void member(std::string& text) { text = take(number()); }
    template <class Enum>
    void member(EnumField<Enum> field)
    {
        const std::uint32_t read = number();
        require(read <= static_cast<std::uint32_t>(field.last));
        if (ok_) field.value = static_cast<Enum>(read);
    }
    void member(std::array<float, 4>& values)
    {
        for (float& value : values) raw(value);
    }
    template <class T>
    void member(std::vector<T>& list)
    {
        const std::uint32_t count = number();
        require(count <= kMostBaked && count <= rest_.size());
        list.clear();
        for (std::uint32_t i = 0; i < count && ok_; ++i) member(list.emplace_back());
    }
    template <class T>
    std::enable_if_t<std::is_class_v<T>> member(T& record)
    {
        fields(*this, record);
    }

private:
    template <class T>
    void raw(T& value)
    {
        const std::string_view from = take(sizeof value);
        if (ok_) std::memcpy(&value, from.data(), sizeof value);
        require(std::isfinite(value));
    }

    std::string_view rest_;
    bool ok_ = true;
};

}  // namespace crevice
