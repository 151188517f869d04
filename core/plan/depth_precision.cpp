// SPDX-License-Identifier: MIT
// The closed forms behind the choice of formats.
#include "core/plan/depth_precision.h"

#include "core/base/text.h"
#include "core/config/values.h"

#include <cfloat>
#include <cmath>
#include <limits>

namespace crevice {
namespace {

// A format further down a list must serve that much farther to be worth leaving an earlier one.
constexpr double kWorthwhile = 1.25;

// Halvings after which an interval is as short as doubles make it, even from 1e7 near planes.
constexpr int kHalvings = 80;

bool isHalf(const FormatInfo& format)
{
    return format.format_class == FormatClass::floating && format.bytes <= 2 * format.channels;
}

// Halves below this are denormals, which a device may take for 0.
constexpr double kLeastHalf = 1.0 / (1 << 14);

// Window depth at a distance, and how view depth changes with it.
struct Window {
    double depth;
    double slope;
};

Window windowAt(const SceneTraits& traits, double distance)
{
    const CameraRange& camera = traits.camera;
    const double farthest = 1 / camera.far_distance;
    Window window{distance * farthest, camera.far_distance};
    if (!traits.orthographic) {
        const double nearest = 1 / camera.near_distance;
        window.depth = (nearest - 1 / distance) / (nearest - farthest);
        window.slope = distance * distance * (nearest - farthest);
    }
    if (traits.reversed_depth)
        window.depth = traits.orthographic
                           ? 1 - window.depth
                           : (1 / distance - farthest) * distance * distance / window.slope;
    window.depth = std::clamp(window.depth, 0.0, 1.0);
    window.slope /= camera.depth_share;
    return window;
}

bool readLinearly(const Description& description, const TargetDesc& target)
{
    for (const PassDesc& pass : description.passes)
        for (const InputDesc& input : pass.inputs)
            if (input.has_filter && input.filter == Filter::linear &&
                (input.from.empty() ? input : input.from).name == target.name)
                return true;
    return false;
}

}  // namespace

StoredSurface storedSurface(const Description& description, const TargetDesc& target, Format format)
{
    const bool drawn = anyOf(description.passes, [&](const PassDesc& pass) {
        return pass.type == PassType::draw && pass.depth.name == target.name;
    });
    return {target.semantic, format, drawn, false};
}

PrecisionNeed precisionNeed(const SceneTraits& traits, double radius, int height)
{
    const CameraRange& camera = traits.camera;
    const double pixels = radius * camera.zoom * height / 2;  // at distance 1
    if (!(camera.far_distance > 0) || !(pixels > 0)) return {};
    PrecisionNeed need{radius * kResolvedShare, camera.far_distance};
    if (!traits.orthographic)
        need.distance = std::min(need.distance, pixels / kLeastRadiusPixels);
    else if (pixels < kLeastRadiusPixels)
        return {};
    return need.distance > camera.near_distance ? need : PrecisionNeed{};
}

const ParamDesc* resolvedLength(const Description& description)
{
    const ParamDesc* least = nullptr;
    for (const ParamDesc& param : description.params)
        if (param.semantic == ParamSemantic::length && (!least || param.value[0] < least->value[0]))
            least = &param;
    return least;
}

PrecisionNeed precisionNeed(const Description& description, const SceneTraits& traits, int height)
{
    const ParamDesc* radius = resolvedLength(description);
    if (!radius) return {};
    return precisionNeed(traits, sceneUnits(*radius, traits, height)[0], height);
}

double formatStep(Format format, double value)
{
    const FormatInfo& info = formatInfo(format);
    constexpr double kLargestHalf = 65504;
    const double largest = isHalf(info) ? kLargestHalf : FLT_MAX;
    if (value > (info.format_class == FormatClass::floating ? largest : 1))
        return std::numeric_limits<double>::infinity();
    if (value <= 0) return info.absolute_step;
    return std::max(info.absolute_step,
                    info.relative_step * std::exp2(std::floor(std::log2(value))));
}

double viewStep(const SceneTraits& traits, const StoredSurface& stored, double distance)
{
    const FormatInfo& info = formatInfo(stored.format);
    if (stored.semantic == Semantic::mask) return 0;
    if (info.format_class != FormatClass::depth) {
        if (stored.semantic == Semantic::other) return 0;
        return std::max(formatStep(stored.format, distance), isHalf(info) ? kLeastHalf : 0.0);
    }
    const Window window = windowAt(traits, distance);
    const double step = formatStep(stored.format, window.depth);
    if (!stored.drawn) return window.slope * step;
    return window.slope * std::max(step, stored.hidden ? kHiddenDepthStep : kDrawnDepthStep);
}

double resolvedDistance(const SceneTraits& traits, const StoredSurface& stored,
                        const PrecisionNeed& need)
{
    const auto met = [&](double distance) {
        return viewStep(traits, stored, distance) <= need.step;
    };
    if (need.distance <= 0 || met(need.distance)) return need.distance;
    double low = traits.camera.near_distance, high = need.distance;
    if (!met(low)) return 0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2;
        (met(middle) ? low : high) = middle;
    }
    return low;
}

Format chooseFormat(const Description& description, const TargetDesc& target,
                    const SceneTraits& traits, const DeviceCaps& caps, int height)
{
    const PrecisionNeed need = precisionNeed(description, traits, height);
    const auto reach = [&](Format format) {
        return resolvedDistance(traits, storedSurface(description, target, format), need);
    };
    Format best = Format::none;
    for (const Format format : target.formats) {
        if (!caps.canRender(format)) continue;
        if (best == Format::none) {
            best = format;
            continue;
        }
        const double farthest = reach(best);
        if (farthest >= need.distance) break;
        const bool loses_filter = formatInfo(best).filterable && !formatInfo(format).filterable &&
                                  readLinearly(description, target);
        if (!loses_filter && reach(format) > kWorthwhile * farthest) best = format;
    }
    return best == Format::none ? target.formats.front() : best;
}

}  // namespace crevice
