// SPDX-License-Identifier: MIT
#include "tools/measure/taps.h"

#include "core/base/text.h"
#include "tools/show/schema/schema.h"

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

constexpr double kCountStep = 1.5;
constexpr double kSizeStep = 1.25;

bool givesSize(const Description& description, const ParamDesc& param)
{
    return anyOf(description.targets, [&param](const TargetDesc& target) {
        return target.size.scale_param.name == param.name;
    });
}

/// To two digits, so that it can be read.
double toTwoDigits(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return std::round(value / unit) * unit;
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

std::vector<std::string> neighbourSettings(const Description& description)
{
    std::vector<std::string> settings;
    for (const ParamDesc& param : description.params) {
        const bool counts = param.type == ParamType::int_ && param.bind == Bind::define;
        const bool sizes = givesSize(description, param);
        const double value = param.value[0];
        if ((!counts && !sizes) || value <= 0) continue;
        for (const bool up : {true, false}) {
            const double step = counts ? kCountStep : kSizeStep;
            const double moved = up ? value * step : value / step;
            double next = counts ? (up ? std::ceil(moved) : std::floor(moved)) : toTwoDigits(moved);
            next = std::clamp(next, param.min, param.max);
            if (next != value) settings.push_back(param.name + "=" + significant(next, 6));
        }
    }
    for (const FeatureDesc& feature : description.features)
        for (std::size_t word = 0; word < feature.values.size(); ++word)
            if (static_cast<int>(word) != feature.value)
                settings.push_back(feature.name + "=" + feature.values[word]);
    return settings;
}

std::vector<std::string> filterSwaps(const SourceSet& sources, const LoadRequest& request)
{
    std::vector<std::string> filters, swaps;
    const Result<nlohmann::ordered_json> listed = listJson(sources, {}, "filters");
    if (!listed) return {};
    for (const auto& filter : listed->begin().value())
        filters.push_back(filter.at("name").get<std::string>());
    for (const std::string& own : filters) {
        LoadRequest same = request;
        same.overrides.push_back(own + "=" + own);
        if (!loadConfig(sources, same)) continue;  // it does not name this one
        for (const std::string& other : filters)
            if (other != own) swaps.push_back(own + "=" + other);
    }
    return swaps;
}

std::vector<std::string> withSetting(std::vector<std::string> overrides, const std::string& setting)
{
    const std::string name = setting.substr(0, setting.find('=') + 1);
    eraseIf(overrides, [&name](const std::string& each) { return startsWith(each, name); });
    overrides.push_back(setting);
    return overrides;
}

}  // namespace crevice
