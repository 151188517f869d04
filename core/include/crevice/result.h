// SPDX-License-Identifier: MIT
// Result<T>: a value, or the diagnostics that say why there is none. Nothing in crevice throws.
#pragma once

#include <crevice/diagnostic.h>

#include <cassert>
#include <optional>
#include <utility>

namespace crevice {

/// Either a value, perhaps with warnings, or at least one error.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)) {}  // NOLINT: implicit, for `return value;`
    Result(T value, Diagnostics warnings)
        : value_(std::move(value)),
          diagnostics_(std::move(warnings))
    {
    }
    Result(Diagnostic error) { diagnostics_.push_back(std::move(error)); }  // NOLINT
    Result(Diagnostics errors) : diagnostics_(std::move(errors))            // NOLINT
    {
        assert(hasErrors(diagnostics_));
    }

    bool ok() const { return value_.has_value(); }
    explicit operator bool() const { return ok(); }

    /// The value. Requires ok().
    T& value()
    {
        assert(ok());
        return *value_;
    }
    const T& value() const
    {
        assert(ok());
        return *value_;
    }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

    /// Errors when not ok(); warnings, usually none, when ok().
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    std::optional<T> value_;
    Diagnostics diagnostics_;
};

/// A Result with no value.
class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Diagnostic error) { diagnostics_.push_back(std::move(error)); }     // NOLINT
    Status(Diagnostics diagnostics) : diagnostics_(std::move(diagnostics)) {}  // NOLINT

    bool ok() const { return !hasErrors(diagnostics_); }
    explicit operator bool() const { return ok(); }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    Diagnostics diagnostics_;
};

}  // namespace crevice
