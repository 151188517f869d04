// SPDX-License-Identifier: MIT
// Medians, costs and valid frames.
#include "tools/bench_times.h"

#include <algorithm>

namespace crevice {
namespace {

constexpr int kTimingAttempts = 10;

}  // namespace

Result<FrameTimes> timeFrame(Renderer& renderer, const Frame& frame)
{
    for (int attempt = 0; attempt < kTimingAttempts; ++attempt) {
        Result<FrameTimes> times = renderer.renderTimed(frame);
        if (!times || times->total_ms >= 0.0) return times;
    }
    return Diagnostic{Code::gl_error, "the GPU's timer gave no valid result in " +
                                          std::to_string(kTimingAttempts) + " frames"};
}

double occlusionCost(const Plan& plan, const FrameTimes& times)
{
    double sum = 0;
    for (std::size_t pass = 0; pass < plan.passes.size(); ++pass)
        if (plan.passes[pass].type != PassType::draw) sum += times.pass_ms[pass];
    return sum;
}

TimeFigures timeFigures(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const auto at = [&values](double share) {
        const double place = share * static_cast<double>(values.size() - 1);
        const auto low = static_cast<std::size_t>(place);
        const std::size_t high = std::min(low + 1, values.size() - 1);
        return values[low] + (values[high] - values[low]) * (place - static_cast<double>(low));
    };
    return {at(0.5), at(0.25), at(0.75)};
}

}  // namespace crevice
