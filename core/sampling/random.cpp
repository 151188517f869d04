// SPDX-License-Identifier: MIT
// A hash for each number.
#include "core/sampling/random.h"

namespace crevice {

namespace {

/// A PCG output function over one step of its generator [Jarzynski, Olano 2020].
std::uint32_t pcg(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

}  // namespace

std::uint32_t randomBits(unsigned seed, unsigned index) { return pcg(index + pcg(seed)); }

float randomFloat(unsigned seed, unsigned index)
{
    return float(randomBits(seed, index) >> 8) * 0x1p-24f;
}

std::vector<int> Stream::permutation(int count)
{
    std::vector<int> numbers(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {  // shuffles while it fills
        const int other = integer(i + 1);
        numbers[std::size_t(i)] = numbers[std::size_t(other)];
        numbers[std::size_t(other)] = i;
    }
    return numbers;
}

}  // namespace crevice
