// SPDX-License-Identifier: MIT
// What the words of a feature set: levels of quality.
#include "core/config/decode_reader.h"
#include "core/config/decode_steps.h"

#include "core/base/text.h"

#include <algorithm>

namespace crevice::table {

namespace {

using Level = FeatureDesc::Level;
using Setting = FeatureDesc::Setting;

class LevelReader {
public:
    LevelReader(const Node& document, Description& description, Report& report)
        : document_(document),
          description_(description),
          report_(report)
    {
    }

    void run();

private:
    void checkWord(const FeatureDesc& feature, const Reference& word);
    bool isDeclared(const FeatureDesc& feature, const Setting& setting);
    void readValue(const FeatureDesc& feature, Setting& setting);
    void complete(FeatureDesc& feature, const Setting& first);

    const Node& document_;
    Description& description_;
    Report& report_;
    std::map<std::string, std::string> setters_;  // features by what they set
};

void LevelReader::checkWord(const FeatureDesc& feature, const Reference& word)
{
    if (contains(feature.values, word.name) || report_.errorAt(feature.pointer + "/values")) return;
    report_.at(word, Code::feature_value,
               "feature '" + feature.name + "' has no value '" + word.name + "'",
               suggestName(word.name, feature.values, "values"));
}

// Whether the config has a param or feature of that name. Where that went with a module that was
// swapped, this is a warning.
bool LevelReader::isDeclared(const FeatureDesc& feature, const Setting& setting)
{
    std::vector<std::string> names = namesOf(description_.params);
    for (const std::string& each : namesOf(description_.features)) names.push_back(each);
    if (contains(names, setting.name)) return true;
    Diagnostic& error = report_.at(
        referenceTo(setting), Code::unknown_param,
        "feature '" + feature.name + "' sets '" + setting.name + "', and no file declares it",
        suggestName(setting.name, std::move(names), "params and features"));
    if (report_.leavesOut(setting.place)) Report::leaveOut(error);
    return false;
}

void LevelReader::readValue(const FeatureDesc& feature, Setting& setting)
{
    const Cursor cursor{*locate(document_, setting.pointer).node,
                        setting.pointer,
                        setting.place,
                        setting.name,
                        setting.name,
                        "write a value that the param or feature may have"};
    if (const ParamDesc* param = findNamed(description_.params, setting.name)) {
        const bool whole = param->type == ParamType::int_;
        if (!report_.errorWithin(param->pointer))
            read(report_, cursor, Numbers{setting.value, componentCount(param->type), whole},
                 range(param->min, param->max, param->unit));
        return;
    }
    const FeatureDesc& other = *findNamed(description_.features, setting.name);
    int index = 0;
    if (!other.sets.empty())
        report_.at(
            referenceTo(setting), Code::cycle,
            "feature '" + feature.name + "' sets '" + other.name + "', which sets values itself",
            "let one of the two set everything");
    else if (!report_.errorWithin(other.pointer))
        read(report_, cursor, Choice{index, other.values, other.boolean}, {});
    setting.value[0] = static_cast<float>(index);
}

// Gives every word a value of what one of them sets.
void LevelReader::complete(FeatureDesc& feature, const Setting& first)
{
    const auto [setter, fresh] = setters_.emplace(first.name, feature.name);
    if (!fresh)
        report_.at(referenceTo(first), Code::name_collision,
                   "features '" + setter->second + "' and '" + feature.name + "' both set '" +
                       first.name + "'",
                   "let one of the two set it");
    Setting initial = first;
    if (const ParamDesc* param = findNamed(description_.params, first.name))
        initial.value = param->value;
    else
        initial.value[0] = static_cast<float>(findNamed(description_.features, first.name)->value);
    for (Level& level : feature.sets)
        if (!findNamed(level.settings, first.name)) level.settings.push_back(initial);
}

void LevelReader::run()
{
    for (FeatureDesc& feature : description_.features) {
        std::map<std::string, Setting> names;
        for (Level& level : feature.sets) {
            checkWord(feature, level.word);
            auto& all = level.settings;
            const auto undeclared = [&](const Setting& each) { return !isDeclared(feature, each); };
            all.erase(std::remove_if(all.begin(), all.end(), undeclared), all.end());
            for (Setting& each : all) readValue(feature, each);
            for (const Setting& each : all) names.emplace(each.name, each);
        }
        for (const std::string& word :
             names.empty() ? std::vector<std::string>() : feature.values) {
            const auto is_word = [&](const Level& each) { return each.word.name == word; };
            if (std::none_of(feature.sets.begin(), feature.sets.end(), is_word))
                feature.sets.push_back({{word, feature.place, feature.pointer}, {}});
        }
        for (const auto& [name, first] : names) complete(feature, first);
    }
}

}  // namespace

void readLevels(const Node& document, Description& description, Report& report)
{
    LevelReader(document, description, report).run();
}

}  // namespace crevice::table
