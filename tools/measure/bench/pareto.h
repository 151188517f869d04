// SPDX-License-Identifier: MIT
// What a set of measured points says: which of them nothing else beats, and how a figure grows.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace crevice {

/// Less is better in both.
struct CostError {
    double cost = 0;
    double error = 0;
};

/// Indexes of the points that no other point beats: none is as cheap and less wrong, or as right
/// and cheaper. Sorted by rising cost, hence falling error; of equal points the first one. Points
/// that are not finite are left out.
std::vector<std::size_t> paretoFront(const std::vector<CostError>& points);

/// The point of a front where more cost begins to buy little: furthest below the straight line
/// between the ends, with cost on a log scale; where none is below, the end with the smaller
/// product of cost and error. `front` as paretoFront gives it, costs above 0. Requires a front that
/// is not empty.
std::size_t balancedPoint(const std::vector<CostError>& points,
                          const std::vector<std::size_t>& front);

/// y = scale * x^slope.
struct PowerLaw {
    double slope = 0;
    double scale = 0;
};

struct XY {
    double x = 0;
    double y = 0;
};

/// Least squares on the logarithms. Points with x or y at or below 0 are left out; nothing comes
/// back where fewer than two different x remain.
std::optional<PowerLaw> fitPowerLaw(const std::vector<XY>& points);

}  // namespace crevice
