// SPDX-License-Identifier: MIT
// Random numbers, stratified and low-discrepancy points.
#include "core/sampling/sequences.h"

#include <cmath>

namespace crevice {

namespace {

/// A PCG output function over one step of its generator [Jarzynski, Olano 2020].
std::uint32_t pcg(std::uint32_t value)
{
    const std::uint32_t state = value * 747796405u + 2891336453u;
    const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// Binary digits of a coordinate; as many as a float has in [0.5, 1).
constexpr unsigned kDigits = 24;

/// Sobol's direction numbers for the bits of an index, one row an axis [Joe, Kuo 2008].
constexpr unsigned kIndexBits = 7;
constexpr unsigned kDirections[3][kIndexBits] = {
    {1, 1, 1, 1, 1, 1, 1}, {1, 3, 5, 15, 17, 51, 85}, {1, 3, 3, 9, 29, 23, 71}};
static_assert(1 << kIndexBits == kMaxSequenceSize);

std::uint32_t sobolDigits(unsigned axis, unsigned index)
{
    std::uint32_t digits = 0;
    for (unsigned bit = 0; bit < kIndexBits; ++bit)
        if (index >> bit & 1u) digits ^= kDirections[axis][bit] << (kDigits - 1 - bit);
    return digits;
}

/// Flips each digit or not, as a hash of all digits before it says [Owen 1995].
std::uint32_t scrambled(std::uint32_t digits, unsigned seed)
{
    std::uint32_t flips = 0;
    for (unsigned before = 0; before < kDigits; ++before) {
        const std::uint32_t prefix = 1u << before | digits >> (kDigits - before);
        flips = flips << 1 | randomBits(seed, prefix) >> 31;
    }
    return digits ^ flips;
}

/// The middle of the interval of kDigits digits that a number in [0, 1) lies in.
double centered(double number)
{
    return (std::floor(number * (1u << kDigits)) + 0.5) / (1u << kDigits);
}

}  // namespace

std::uint32_t randomBits(unsigned seed, unsigned index)
{
    return pcg(index + pcg(seed));
}

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

std::vector<CubePoint> stratifiedPoints(int count, unsigned seed)
{
    Stream stream(seed);
    std::vector<CubePoint> points(static_cast<std::size_t>(count));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<int> strata = stream.permutation(count);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i][axis] = centered((strata[i] + stream.number()) / count);
    }
    return points;
}

std::vector<CubePoint> lowDiscrepancyPoints(int count, unsigned seed)
{
    std::vector<CubePoint> points(static_cast<std::size_t>(count));
    for (unsigned axis = 0; axis < 3; ++axis)
        for (unsigned i = 0; i < points.size(); ++i) {
            const std::uint32_t digits = scrambled(sobolDigits(axis, i), randomBits(seed, axis));
            points[i][axis] = (digits + 0.5) / (1u << kDigits);
        }
    return points;
}

}  // namespace crevice
