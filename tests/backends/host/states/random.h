// SPDX-License-Identifier: MIT
// Random choices that a seed repeats.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>

namespace crevice {

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }

    /// [0, count).
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    bool coin() { return below(2) == 1; }

    /// [0, 1), a multiple of 1/256.
    float unit() { return static_cast<float>(below(256)) / 256.0f; }

    template <class T>
    T pick(std::initializer_list<T> of)
    {
        return of.begin()[below(static_cast<int>(of.size()))];
    }
    template <class List>
    auto pick(const List& of)
    {
        return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
    }

private:
    std::mt19937 engine_;
};

}  // namespace crevice
