// SPDX-License-Identifier: MIT
// Depth taps a pixel.
#include "tools/measure/taps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

int valueOf(const ParamDesc& param) { return static_cast<int>(param.value[0]); }

bool holds(const ParamDesc& param, int value) { return value >= param.min && value <= param.max; }

std::string assignment(const ParamDesc& param, int value)
{
    return param.name + "=" + std::to_string(value);
}

/// The pair of divisors of `product` whose ratio is nearest to that of the config; {0, 0} for none.
std::pair<int, int> dividedBetween(const ParamDesc& slices, const ParamDesc& steps, int product)
{
    const double ratio = std::log(static_cast<double>(valueOf(slices)) / valueOf(steps));
    double nearest = std::numeric_limits<double>::infinity();
    std::pair<int, int> best = {0, 0};
    for (int across = 1; across <= product; ++across) {
        const int along = product / across;
        if (product % across != 0 || !holds(slices, across) || !holds(steps, along)) continue;
        const double off = std::abs(std::log(static_cast<double>(across) / along) - ratio);
        if (off < nearest) best = {across, along};
        nearest = std::min(nearest, off);
    }
    return best;
}

}  // namespace

int samplesOf(const Description& description)
{
    if (const ParamDesc* samples = findNamed(description.params, "samples"))
        return valueOf(*samples);
    const ParamDesc* slices = findNamed(description.params, "slices");
    const ParamDesc* steps = findNamed(description.params, "steps");
    return slices && steps ? 2 * valueOf(*slices) * valueOf(*steps) : 0;
}

std::vector<std::string> overridesFor(const Description& description, int count)
{
    if (const ParamDesc* samples = findNamed(description.params, "samples")) {
        if (!holds(*samples, count)) return {};
        return {assignment(*samples, count)};
    }
    const ParamDesc* slices = findNamed(description.params, "slices");
    const ParamDesc* steps = findNamed(description.params, "steps");
    if (!slices || !steps || count % 2 != 0) return {};
    const auto [across, along] = dividedBetween(*slices, *steps, count / 2);
    if (across == 0) return {};
    return {assignment(*slices, across), assignment(*steps, along)};
}

}  // namespace crevice
