// SPDX-License-Identifier: MIT
// What the words of a feature set: levels of quality.
#include "core/config/decode_reader.h"

#include "core/base/text.h"

#include <algorithm>
#include <set>

namespace crevice::table {

namespace {

constexpr std::size_t kMaxSettings = 16384;  // of one feature; each takes some hundred bytes

using Level = FeatureDesc::Level;
using Setting = FeatureDesc::Setting;

void checkWord(const FeatureDesc& feature, const std::set<std::string>& words,
               const Reference& word, Report& report)
{
    if (words.count(word.name) > 0 || report.errorAt(feature.pointer + "/values")) return;
    report.at(word, Code::feature_value,
              "feature '" + feature.name + "' has no value '" + word.name + "'",
              suggestName(word.name, feature.values, "values"));
}

// Whether the config has a param or feature of that name. Where that went with a module that was
// swapped, this is a warning.
bool isDeclared(const std::vector<std::string>& names, const FeatureDesc& feature,
                const Setting& setting, Report& report)
{
    if (contains(names, setting.name)) return true;
    if (report.full()) return report.count(), false;
    Reported& error = report.at(
        referenceTo(setting), Code::unknown_param,
        "feature '" + feature.name + "' sets '" + setting.name + "', and no file declares it",
        suggestName(setting.name, names, "params and features"));
    if (report.leavesOut(setting.place)) Report::leaveOut(error);
    return false;
}

void readValue(const Node& document, const Description& description, const FeatureDesc& feature,
               Setting& setting, Report& report)
{
    const Cursor cursor{*locate(document, setting.pointer).node,
                        setting.pointer,
                        setting.place,
                        setting.name,
                        setting.name,
                        "write a value that the param or feature may have"};
    if (const ParamDesc* param = findNamed(description.params, setting.name)) {
        const bool whole = param->type == ParamType::int_;
        if (!report.errorWithin(param->pointer))
            read(report, cursor, Numbers{setting.value, componentCount(param->type), whole},
                 range(param->min, param->max, param->unit));
        return;
    }
    const FeatureDesc& other = *findNamed(description.features, setting.name);
    int index = 0;
    if (!other.sets.empty())
        report.at(
            referenceTo(setting), Code::cycle,
            "feature '" + feature.name + "' sets '" + other.name + "', which sets values itself",
            "let one of the two set everything");
    else if (!report.errorWithin(other.pointer))
        read(report, cursor, Choice{index, other.values, other.boolean}, {});
    setting.value[0] = static_cast<float>(index);
}

// Gives every word of the feature a level.
void addLevels(FeatureDesc& feature)
{
    std::set<std::string> words;
    for (const Level& each : feature.sets) words.insert(each.word.name);
    for (const std::string& word : feature.values)
        if (words.insert(word).second)
            feature.sets.push_back({{word, feature.place, feature.pointer}, {}});
}

// Whether all levels together may set so much.
bool fits(const FeatureDesc& feature, std::size_t names, Report& report)
{
    if (feature.sets.size() * names <= kMaxSettings) return true;
    report.at(referenceTo(feature), Code::over_limit,
              "feature '" + feature.name + "' has " + std::to_string(feature.sets.size()) +
                  " words that set " + std::to_string(names) + " values, more than " +
                  std::to_string(kMaxSettings) + " together",
              "let it set less, or have fewer words");
    return false;
}

// Gives every word of the feature a value of what one of them sets.
void complete(const Description& description, FeatureDesc& feature, const Setting& first)
{
    Setting initial = first;
    if (const ParamDesc* param = findNamed(description.params, first.name))
        initial.value = param->value;
    else
        initial.value[0] = static_cast<float>(findNamed(description.features, first.name)->value);
    for (Level& level : feature.sets)
        if (!findNamed(level.settings, first.name)) level.settings.push_back(initial);
}

}  // namespace

void readLevels(const Node& document, Description& description, Report& report)
{
    std::map<std::string, std::string> setters;  // features by what they set
    std::vector<std::string> declared = namesOf(description.params);
    for (const FeatureDesc& each : description.features) declared.push_back(each.name);
    for (FeatureDesc& feature : description.features) {
        std::map<std::string, Setting> names;
        const std::set<std::string> words(feature.values.begin(), feature.values.end());
        for (Level& level : feature.sets) {
            checkWord(feature, words, level.word, report);
            auto& all = level.settings;
            all.erase(std::remove_if(all.begin(), all.end(),
                                     [&](const Setting& each) {
                                         return !isDeclared(declared, feature, each, report);
                                     }),
                      all.end());
            for (Setting& each : all) {
                readValue(document, description, feature, each, report);
                names.emplace(each.name, each);
            }
        }
        if (names.empty()) continue;
        addLevels(feature);
        if (!fits(feature, names.size(), report)) continue;
        for (const auto& [name, first] : names) {
            complete(description, feature, first);
            const auto [setter, fresh] = setters.emplace(name, feature.name);
            if (!fresh)
                report.at(referenceTo(first), Code::name_collision,
                          "features '" + setter->second + "' and '" + feature.name +
                              "' both set '" + name + "'",
                          "let one of the two set it");
        }
    }
}

}  // namespace crevice::table
