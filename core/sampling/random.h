// SPDX-License-Identifier: MIT
// Random numbers from a seed, the same on every platform: what the generators shape.
//
// Source
//   Jarzynski, Olano 2020, "Hash Functions for GPU Rendering" - the PCG hash behind every number.
#pragma once

#include <cstdint>
#include <vector>

namespace crevice {

/// 32 random bits for (seed, index).
std::uint32_t randomBits(unsigned seed, unsigned index);

/// A uniform number in [0, 1) for (seed, index).
float randomFloat(unsigned seed, unsigned index);

/// The numbers of one seed, one after the other.
class Stream {
public:
    explicit Stream(unsigned seed) : seed_(seed) {}

    /// In [0, 1).
    double number() { return randomFloat(seed_, index_++); }

    /// In [0, count).
    int integer(int count) { return int(randomBits(seed_, index_++) % unsigned(count)); }

    /// The numbers from 0 to count - 1, shuffled.
    std::vector<int> permutation(int count);

private:
    unsigned seed_;
    unsigned index_ = 0;
};

}  // namespace crevice
