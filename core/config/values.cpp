// SPDX-License-Identifier: MIT
// What a value may be, and what becomes of it where the config changes.
#include "core/config/values.h"

#include "core/base/text.h"
#include "core/sampling/generators.h"

#include <cfloat>
#include <cmath>

namespace crevice {
namespace {

Diagnostic paramError(Code code, const ParamDesc& param, const std::string& what, std::string help)
{
    return {code, param.name + " " + what, std::move(help), param.place, param.pointer};
}

std::string numberText(double value) { return significant(value, 6); }

std::string rangeText(const ParamDesc& param)
{
    return "[" + numberText(param.min) + ", " + numberText(param.max) + "]" +
           (param.unit.empty() ? "" : " " + param.unit);
}

Diagnostic dropped(const std::string& what, const Named& old, const std::string& why)
{
    return asWarning({Code::value_dropped,
                      what + " '" + old.name + "' is no longer what was set at run time: " + why,
                      "set it again, to a value that the config has now"});
}

void carryParam(const ParamDesc& old, Description& next, Diagnostics& warnings)
{
    const int at = indexOf(next.params, old.name);
    const bool there = at >= 0 && next.params[at].type == old.type;
    const Status fits =
        there ? checkValue(next.params[at], old.value.data(), componentCount(old.type)) : Status{};
    if (there && fits)
        next.params[at].value = old.value;
    else
        warnings.push_back(dropped(
            "param", old, there ? fits.diagnostics()[0].message : "the config has none like it"));
}

void carryFeature(const FeatureDesc& old, Description& next, Diagnostics& warnings)
{
    const std::string& word = old.values[old.value];
    const int at = indexOf(next.features, old.name);
    const std::vector<std::string> words =
        at < 0 ? std::vector<std::string>() : next.features[at].values;
    const auto found = std::find(words.begin(), words.end(), word);
    if (found == words.end()) {
        warnings.push_back(dropped("feature", old, "the config has no '" + word + "'"));
        return;
    }
    next.features[at].value = static_cast<int>(found - words.begin());
    applyLevel(next, old.name);
}

}  // namespace

double valueOf(const ProductDesc& product, const std::vector<ParamDesc>& params)
{
    double value = product.factor;
    for (const Reference& each : product.params)
        if (const ParamDesc* param = findNamed(params, each.name)) value *= double{param->value[0]};
    return value;
}

int componentCount(ParamType type)
{
    constexpr int kCounts[] = {1, 1, 2, 3, 4};  // in the order of ParamType
    return kCounts[static_cast<int>(type)];
}

GlslType glslTypeOf(ParamType type)
{
    constexpr GlslType kTypes[] = {GlslType::float_, GlslType::int_, GlslType::vec2, GlslType::vec3,
                                   GlslType::vec4};
    return kTypes[static_cast<int>(type)];
}

Status checkValue(const ParamDesc& param, const float* values, int count)
{
    const int components = componentCount(param.type);
    const bool length = count == 3 && isLength(param) && std::count(values, values + 3, 0.0f) > 1;
    if (count != components && !length)
        return paramError(Code::bad_length, param,
                          "has " + std::to_string(components) + " components, and " +
                              std::to_string(count) + " values were given",
                          "give one value for each component");
    for (int i = 0; i < count; ++i) {
        if (!std::isfinite(values[i]))
            return paramError(Code::not_finite, param, "must be finite", "in " + rangeText(param));
        // As floats, so that a bound that no float holds, such as 0.01, can be given.
        if (values[i] < static_cast<float>(param.min) || values[i] > static_cast<float>(param.max))
            return paramError(Code::out_of_range, param,
                              numberText(values[i]) + " is outside " + rangeText(param),
                              "give a value in that range");
        constexpr float kLimit = 2147483648.0f;  // the least float that no int holds
        const bool holds = values[i] >= -kLimit && values[i] < kLimit;
        if (param.type == ParamType::int_ && !(holds && values[i] == std::floor(values[i])))
            return paramError(Code::out_of_range, param,
                              numberText(values[i]) + " is no whole number",
                              "give a whole number in " + rangeText(param));
    }
    return {};
}

bool isAll(const std::array<float, 4>& values, ParamType type, float value)
{
    return std::all_of(values.begin(), values.begin() + componentCount(type),
                       [&](float each) { return each == value; });
}

Values valuesOf(const Description& description)
{
    Values values;
    for (const ParamDesc& param : description.params) values.params.push_back(param.value);
    for (const FeatureDesc& feature : description.features)
        values.features.push_back(feature.value);
    return values;
}

std::vector<std::string> textureNames(const Description& description)
{
    std::vector<std::string> names = namesOf(description.targets);
    for (const TargetDesc& each : description.targets)
        if (each.history) names.push_back(historyName(each));
    for (const GeneratedDesc& each : description.generated)  // one that is broken names none
        if (each.generator.empty() || generatesTexture(each.generator)) names.push_back(each.name);
    for (const ImportDesc& each : description.imports)
        if (each.type == ImportType::texture) names.push_back(each.name);
    return names;
}

bool isLength(const ParamDesc& param)
{
    return param.semantic == ParamSemantic::length && param.type == ParamType::float_ &&
           param.bind == Bind::uniform;
}

bool isRelative(const ParamDesc& param)
{
    return isLength(param) && (param.value[1] != 0 || param.value[2] != 0);
}

bool takeLength(std::string_view text, std::array<float, 4>& value)
{
    const double number = takeNumber(text).value_or(-1);
    if (!(number >= 0 && number <= FLT_MAX) || (text != "%" && text != "px")) return false;
    value = {};
    value[text == "%" ? 1 : 2] = static_cast<float>(number);
    return true;
}

std::array<float, 4> sceneUnits(const ParamDesc& param, const SceneTraits& traits, int height)
{
    if (!isRelative(param)) return param.value;
    const auto part = [](double count, double length) {
        return count == 0 ? 0 : length > 0 ? count * length : NAN;
    };
    const double distance = traits.orthographic ? 1 : traits.scale.distance;
    const double pixel = 2 * distance / (traits.camera.zoom * height);
    const double sum = param.value[0] + part(param.value[1], traits.scale.diagonal / 100) +
                       part(param.value[2], pixel);
    const double most = part(param.value[3], pixel * height / 100);
    return {
        static_cast<float>(std::clamp(most > 0 ? std::min(sum, most) : sum, param.min, param.max))};
}

void applyLevel(Description& description, std::string_view feature)
{
    const FeatureDesc& setter = *findNamed(description.features, feature);
    for (const FeatureDesc::Level& level : setter.sets) {
        if (level.name != setter.values[setter.value]) continue;
        for (const FeatureDesc::Setting& each : level.settings) {
            const int param = indexOf(description.params, each.name);
            const int other = indexOf(description.features, each.name);
            if (param >= 0)
                description.params[param].value = each.value;
            else
                description.features[other].value = static_cast<int>(each.value[0]);
        }
    }
}

Values untouched(const Values& loaded, const Description& now)
{
    Description base = now;
    for (std::size_t i = 0; i < base.params.size(); ++i) base.params[i].value = loaded.params[i];
    for (std::size_t i = 0; i < base.features.size(); ++i)
        if (base.features[i].sets.empty()) base.features[i].value = loaded.features[i];
    for (const FeatureDesc& each : now.features) applyLevel(base, each.name);
    Values values = valuesOf(base);
    for (std::size_t i = 0; i < base.features.size(); ++i)
        if (!base.features[i].sets.empty()) values.features[i] = loaded.features[i];
    return values;
}

Diagnostics carryOver(const Values& loaded, const Description& now, Description& next)
{
    Diagnostics warnings;
    const Values before = untouched(loaded, now);
    for (const bool sets : {true, false})  // first what sets others
        for (std::size_t i = 0; i < now.features.size(); ++i)
            if (now.features[i].sets.empty() != sets && now.features[i].value != before.features[i])
                carryFeature(now.features[i], next, warnings);
    for (std::size_t i = 0; i < now.params.size(); ++i)
        if (now.params[i].value != before.params[i]) carryParam(now.params[i], next, warnings);
    return warnings;
}

}  // namespace crevice
