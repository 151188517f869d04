// SPDX-License-Identifier: MIT
// Values that differ, as a patch.
#include "core/config/values.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>

namespace crevice {

namespace {

std::string valueJson(const ParamDesc& param)
{
    if (param.type == ParamType::int_) return std::to_string(static_cast<int>(param.value[0]));
    const int count = componentCount(param.type);
    std::string text;
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + shortest(param.value[i]);
    return count > 1 ? "[" + text + "]" : text;
}

std::string valueJson(const FeatureDesc& feature)
{
    const std::string& word = feature.values[feature.value];
    return feature.boolean ? word : jsonString(word);
}

// One more member of an object that begins with `opening`.
void add(std::string& text, const std::string& opening, const std::string& member)
{
    text += (text.empty() ? opening : ", ") + member;
}

}  // namespace

Values valuesOf(const Description& description)
{
    Values values;
    for (const ParamDesc& param : description.params) values.params.push_back(param.value);
    for (const FeatureDesc& feature : description.features)
        values.features.push_back(feature.value);
    return values;
}

std::string valuesPatch(const Values& loaded, const Description& now)
{
    std::string params, features;
    for (std::size_t i = 0; i < now.params.size(); ++i) {
        const ParamDesc& param = now.params[i];
        if (param.value != loaded.params[i])
            add(params, "\"params\": {", jsonString(param.name) + ": " + valueJson(param));
    }
    for (std::size_t i = 0; i < now.features.size(); ++i) {
        const FeatureDesc& feature = now.features[i];
        if (feature.value != loaded.features[i])
            add(features, "\"features\": {", jsonString(feature.name) + ": " + valueJson(feature));
    }
    std::string text;
    for (const std::string& section : {params, features})
        if (!section.empty()) add(text, "", section + "}");
    return "{" + text + "}";
}

}  // namespace crevice
