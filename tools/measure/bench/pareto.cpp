// SPDX-License-Identifier: MIT
// Pareto fronts and power laws.
#include "tools/measure/bench/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {

std::vector<std::size_t> paretoFront(const std::vector<CostError>& points)
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&points](std::size_t a, std::size_t b) {
        if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
        return points[a].error < points[b].error;
    });

    std::vector<std::size_t> front;
    double least_error = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= least_error) continue;
        least_error = points[i].error;
        front.push_back(i);
    }
    return front;
}

std::size_t balancedPoint(const std::vector<CostError>& points,
                          const std::vector<std::size_t>& front)
{
    const CostError first = points[front.front()], last = points[front.back()];
    const double width = std::log(last.cost / first.cost), height = first.error - last.error;
    const bool last_is_better = last.cost * last.error < first.cost * first.error;
    std::size_t best = last_is_better ? front.back() : front.front();
    double best_depth = 0.0;
    for (const std::size_t i : front) {
        // Both from 0 to 1 along the front, so that the line between the ends is at + down = 1.
        const double along = std::log(points[i].cost / first.cost) / width;
        const double up = (points[i].error - last.error) / height;
        const double depth = 1.0 - along - up;
        if (depth <= best_depth) continue;
        best_depth = depth;
        best = i;
    }
    return best;
}

std::optional<PowerLaw> fitPowerLaw(const std::vector<XY>& points)
{
    double count = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const XY& point : points) {
        if (!(point.x > 0.0) || !(point.y > 0.0)) continue;
        const double x = std::log(point.x), y = std::log(point.y);
        count += 1.0;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
        low = std::min(low, x);
        high = std::max(high, x);
    }
    if (count < 2.0 || low == high) return std::nullopt;
    const double slope = (count * sum_xy - sum_x * sum_y) / (count * sum_xx - sum_x * sum_x);
    return PowerLaw{slope, std::exp((sum_y - slope * sum_x) / count)};
}

}  // namespace crevice
