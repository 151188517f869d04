// SPDX-License-Identifier: MIT
// Compares two benches point by point.
#include "tools/bench/compare.h"

#include "tools/bench/views.h"

#include <cmath>

namespace crevice {
namespace {

/// The same point in other results; null when there is none.
const BenchPoint* findSame(const std::vector<BenchPoint>& points, const BenchPoint& wanted)
{
    const std::string no_op = noOpOf(wanted);
    const BenchPoint* found = nullptr;
    for (const BenchPoint& point : points) {
        if (noOpOf(point) != no_op) continue;
        if (point.device == wanted.device) return &point;
        if (!found) found = &point;
    }
    return found;
}

std::string nameOf(const BenchPoint& point)
{
    return pointLabel(point) + ", " + viewName(point.scene, point.camera) + ", " +
           extentName(point.extent);
}

class Comparer {
public:
    explicit Comparer(const BenchLimits& limits) : limits_(limits) {}

    void compare(const BenchPoint& before, const BenchPoint& now)
    {
        point_ = nameOf(before);
        if (!now.failure.empty()) {
            result.failed.push_back(point_ + ": " + now.failure);
            return;
        }
        ++result.compared;
        const bool same_device = before.device == now.device;
        most_error_ =
            same_device && before.version == now.version ? limits_.error : limits_.other_error;
        compareError("rmse", before.error.rmse, now.error.rmse);
        compareError("rmse_fit", before.error.rmse_fit, now.error.rmse_fit);
        compareError("bias without its sign", std::abs(before.error.bias),
                     std::abs(now.error.bias));
        if (limits_.errors_only) return;
        if (!same_device) {
            ++result.without_ratios;
            return;
        }
        compareRatio("ratio_copy", before.ratio_copy, now.ratio_copy);
        compareRatio("ratio_learnopengl", before.ratio_learnopengl, now.ratio_learnopengl);
    }

    BenchComparison result;

private:
    void compareError(const char* figure, double before, double now)
    {
        if (now > before + most_error_)
            result.worse.push_back({point_, figure, before, now, before + most_error_});
        else if (now < before - most_error_)
            result.better.push_back({point_, figure, before, now, before + most_error_});
    }

    void compareRatio(const char* figure, double before, double now)
    {
        if (!(before > 0.0) || !(now > 0.0)) return;  // one of the runs had nothing to divide by
        const double most = 1.0 + limits_.ratio;
        if (now > before * most)
            result.worse.push_back({point_, figure, before, now, before * most});
        else if (now * most < before)
            result.better.push_back({point_, figure, before, now, before * most});
    }

    BenchLimits limits_;
    double most_error_ = 0;
    std::string point_;
};

}  // namespace

BenchComparison compareBenches(const std::vector<BenchPoint>& before,
                               const std::vector<BenchPoint>& now, const BenchLimits& limits)
{
    Comparer comparer(limits);
    for (const BenchPoint& point : before) {
        if (!point.failure.empty()) continue;
        if (const BenchPoint* same = findSame(now, point))
            comparer.compare(point, *same);
        else
            comparer.result.missing.push_back(nameOf(point));
    }
    return std::move(comparer.result);
}

}  // namespace crevice
