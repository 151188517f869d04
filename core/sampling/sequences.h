// SPDX-License-Identifier: MIT
// Numbers and points from a seed, the same on every platform: what the generators shape.
//
// Sources
//   Jarzynski, Olano 2020, "Hash Functions for GPU Rendering" - the PCG hash behind every number.
//   McKay, Beckman, Conover 1979, "A Comparison of Three Methods for Selecting Values of Input
//     Variables in the Analysis of Output from a Computer Code" - the stratified points.
//   Sobol' 1967, "On the distribution of points in a cube and the approximate evaluation of
//     integrals"; Joe, Kuo 2008, "Constructing Sobol sequences with better two-dimensional
//     projections" - the low-discrepancy points.
//   Owen 1995, "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences" - their scrambling by a seed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace crevice {

/// Most points of one set.
constexpr int kMaxSequenceSize = 128;

/// Coordinates in (0, 1): odd multiples of 2^-25, so that neither 0, 1/2 nor 1 is among them.
using CubePoint = std::array<double, 3>;

/// A Latin hypercube: along each axis, one point in each of `count` equal strata. The error of a
/// mean over the points falls with about count^-0.6, where random ones have count^-0.5.
/// Requires a count in [1, kMaxSequenceSize]; the mean over seeds is right for each.
std::vector<CubePoint> stratifiedPoints(int count, unsigned seed);

/// The first points of Sobol's sequence, scrambled by the seed. The error falls with about count^-1
/// for a smooth function and is at its least where `count` is a power of two.
/// Requires a count in [1, kMaxSequenceSize]; the mean over seeds is right for each.
std::vector<CubePoint> lowDiscrepancyPoints(int count, unsigned seed);

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
