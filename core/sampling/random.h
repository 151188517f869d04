// SPDX-License-Identifier: MIT
// Random numbers from a seed, the same on every platform: what the generators shape.
//
// Source: Jarzynski, Olano 2020 - the PCG hash behind every number.
#pragma once

#include <cstdint>

namespace crevice {

/// A PCG output function over one step of its generator [Jarzynski, Olano 2020].
inline std::uint32_t pcg(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// 32 random bits for (seed, index).
inline std::uint32_t randomBits(unsigned seed, unsigned index) { return pcg(index + pcg(seed)); }

/// A uniform number in [0, 1) for (seed, index).
inline float randomFloat(unsigned seed, unsigned index)
{
    return float(randomBits(seed, index) >> 8) * 0x1p-24f;
}

/// The numbers of one seed, one after the other.
class Stream {
public:
    explicit Stream(unsigned seed) : seed_(seed) {}

    /// In [0, 1).
    double number() { return randomFloat(seed_, index_++); }

    /// In [0, count).
    int integer(int count) { return int(randomBits(seed_, index_++) % unsigned(count)); }

private:
    unsigned seed_;
    unsigned index_ = 0;
};

}  // namespace crevice
