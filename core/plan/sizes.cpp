// SPDX-License-Identifier: MIT
#include "core/plan/sizes.h"

#include "core/base/text.h"

#include <cmath>
#include <map>

namespace crevice {
namespace {

constexpr double kLargest = 1e9;  // fits an int; far over what any device takes

// Rounded up, but for what rounding `scale` to a float adds: 1.2f is above 1.2; 360 * 1.2 is 432.
int scaled(int size, float scale)
{
    constexpr double kEpsilon = 6.0e-8;  // 2^-24: half a step of floats, relative
    const double product = size * (scale * (1 - kEpsilon));
    return static_cast<int>(std::max(1.0, std::ceil(std::min(product, kLargest))));
}

int texels(const Description& description, const ProductDesc& product)
{
    const double value = valueOf(product, description.params);
    return static_cast<int>(std::clamp(std::round(value), 1.0, kLargest));
}

// With whole pixels added on either side, rounded up but for what the rounding of `scale` adds.
// Shaders find `size` from what this returns: effects/common/guard_band.glsl.
int bordered(int size, float scale)
{
    constexpr double kEpsilon = 0.01;  // of a pixel, as there
    const double border = std::ceil(0.5 * size * (double(scale) - 1.0) - kEpsilon);
    return static_cast<int>(std::min(size + 2.0 * std::max(0.0, border), kLargest));
}

// The scale itself, or one at which the border ends where the device's textures do.
float fittingScale(int size, float scale, int limit)
{
    if (bordered(size, scale) <= limit) return scale;
    return static_cast<float>(1.0 + 2.0 * std::max(0, (limit - size) / 2) / size);
}

// As fittingScale, of all targets whose borders the param gives.
float fittingScale(const Description& description, const ParamDesc& param, const TargetSizes& sizes,
                   int limit)
{
    float scale = param.value[0];
    for (std::size_t i = 0; i < description.targets.size(); ++i) {
        const SizeDesc& desc = description.targets[i].size;
        if (!desc.border || desc.scale_param.name != param.name) continue;
        const Extent inner = sizes.of(sizes.followed(static_cast<int>(i)));
        for (const int size : {inner.width, inner.height})
            scale = std::min(scale, fittingScale(size, scale, limit));
    }
    return scale;
}

}  // namespace

std::string text(const Extent& extent)
{
    return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

std::string endsAt(const DeviceCaps& caps)
{
    const int limit = caps.max_texture_size;
    return "the device's textures end at " + text(Extent{limit, limit});
}

std::optional<Description> fitBorders(const Description& description, const CompileOptions& options,
                                      const DeviceCaps& caps, std::vector<Elided>& elided)
{
    std::optional<Description> fitted;
    const TargetSizes sizes(description, options.extent);
    for (std::size_t i = 0; i < description.params.size(); ++i) {
        const ParamDesc& param = description.params[i];
        if (param.bind != Bind::define) continue;  // what a host sets does not pass by here
        const float scale = fittingScale(description, param, sizes, caps.max_texture_size);
        if (scale >= param.value[0] || scale < param.min) continue;
        if (!fitted) fitted = description;
        fitted->params[i].value[0] = scale;
        elided.push_back({"part of " + param.name, "device",
                          endsAt(caps) + ", so it is " + shortest(scale) + " instead of " +
                              shortest(param.value[0])});
    }
    return fitted;
}

TargetSizes::TargetSizes(const Description& description, Extent view)
    : description_(description),
      view_(view),
      extents_(description.targets.size())
{
    const std::vector<TargetDesc>& targets = description.targets;
    std::map<std::string_view, int> indices;
    for (std::size_t i = 0; i < targets.size(); ++i)
        indices.try_emplace(targets[i].name, static_cast<int>(i));
    for (const TargetDesc& target : targets) {
        const auto found = indices.find(target.size.of.name);
        followed_.push_back(found == indices.end() ? -1 : found->second);
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        std::vector<int> chain;  // those that are not known yet; decode lets none close a circle
        for (int at = static_cast<int>(i); at >= 0 && extents_[at].width == 0; at = followed_[at])
            chain.push_back(at);
        for (auto at = chain.rbegin(); at != chain.rend(); ++at) {
            const SizeDesc& size = targets[*at].size;
            const ParamDesc* param = findNamed(description.params, size.scale_param.name);
            const float scale = param ? param->value[0] : size.scale;
            const auto factor = size.border ? bordered : scaled;
            const Extent base = of(followed_[*at]);
            extents_[*at] = {factor(base.width, scale), factor(base.height, scale)};
            if (size.width.factor > 0)
                extents_[*at] = {texels(description, size.width), texels(description, size.height)};
        }
    }
}

float TargetSizes::viewsOf(int target) const
{
    int sized = target;
    while (sized >= 0 && !description_.targets[sized].size.border) sized = followed_[sized];
    if (sized < 0) return 0.0f;
    const Extent size = of(target);
    return std::max(static_cast<float>(size.width) / static_cast<float>(view_.width),
                    static_cast<float>(size.height) / static_cast<float>(view_.height));
}

int depthOf(const Description& description, int target)
{
    const TargetDesc& desc = description.targets[target];
    return isVolume(desc) ? texels(description, desc.size.depth) : 0;
}

int askedSamples(const Description& description, int target)
{
    const TargetDesc& desc = description.targets[target];
    const ParamDesc* param = findNamed(description.params, desc.samples_param.name);
    return param ? static_cast<int>(param->value[0]) : desc.samples;
}

int nearestCount(std::uint32_t counts, int asked)
{
    asked = std::clamp(asked, 1, kMaxSamples + 1);
    const auto has = [counts](int samples) { return (counts >> (samples - 1) & 1u) != 0; };
    for (int samples = asked; samples <= kMaxSamples; ++samples)
        if (has(samples)) return samples;
    for (int samples = asked - 1; samples > 1; --samples)
        if (has(samples)) return samples;
    return 1;
}

int generatedCount(const Description& description, const GeneratedDesc& generated)
{
    const ParamDesc* param = findNamed(description.params, generated.count_param.name);
    return param ? static_cast<int>(param->value[0]) : generated.count;
}

bool storedAlike(Format wanted, Format given)
{
    const FormatInfo& stored = formatInfo(wanted);
    const FormatInfo& by = formatInfo(given);
    return by.format_class == stored.format_class && by.channels >= stored.channels &&
           by.absolute_step == stored.absolute_step && by.relative_step == stored.relative_step;
}

std::string stepDefine(const std::string& texture) { return upperCase(texture) + "_STEP"; }

std::string stepsOf(Format format)
{
    const FormatInfo& info = formatInfo(format);
    return "vec2(" + scientific(info.absolute_step, 3) + ", " + scientific(info.relative_step, 3) +
           ")";
}

std::string literal(const ParamDesc& param)
{
    if (param.type == ParamType::int_) return std::to_string(static_cast<int>(param.value[0]));
    std::string text = shortest(param.value[0]);
    if (text.find_first_of(".e") == text.npos) text += ".0";
    return text;
}

}  // namespace crevice
