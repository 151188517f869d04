// SPDX-License-Identifier: MIT
// A value that takes the room of a pointer until it is changed for the first time.
#pragma once

#include <memory>
#include <utility>

namespace crevice {

/// A T, copied with its owner. T may be incomplete where a Lazy<T> is declared.
template <class T>
class Lazy {
public:
    Lazy() = default;
    Lazy(const Lazy& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
    Lazy(Lazy&& other) noexcept = default;
    Lazy& operator=(Lazy other) noexcept
    {
        value_ = std::move(other.value_);
        return *this;
    }

    const T& get() const
    {
        static const T kEmpty{};
        return value_ ? *value_ : kEmpty;
    }

    T& change()
    {
        if (!value_) value_ = std::make_unique<T>();
        return *value_;
    }

private:
    std::unique_ptr<T> value_;
};

}  // namespace crevice
