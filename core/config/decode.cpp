// SPDX-License-Identifier: MIT
// From a merged document to a description: cursors, errors in the document's order, and levels of
// quality, which are read after all that they may set.
#include <crevice/config.h>

#include "core/base/text.h"
#include "core/config/decode_reader.h"
#include "core/config/fields.h"
#include "core/config/values.h"
#include "core/json/merge.h"

namespace crevice::table {
namespace {

std::vector<Note> notesOf(const std::vector<Place>& origins)
{
    std::vector<Note> notes;
    for (const Place& origin : origins) notes.push_back({origin, "the base value was set here"});
    return notes;
}

// The child of that key, or of that index where the parent is a list.
const Node* childAt(const Node& parent, const std::string& key, std::size_t& index)
{
    for (index = 0; index < parent.members.size(); ++index)
        if (parent.members[index].key == key) return &parent.members[index].value;
    for (index = 0; index < parent.items.size(); ++index)
        if (std::to_string(index) == key) return &parent.items[index];
    return nullptr;
}

void noteDeleted(const Node& document, Description& description)
{
    for (const Member& each : document.deleted) {
        if (each.value.kind == Node::Kind::string)
            description.left_out.push_back({each.key, each.value.text});
        else
            description.deleted.push_back({each.key, each.key_place, memberPointer("", each.key)});
    }
    for (const Member& section : document.members) {
        const std::string pointer = memberPointer("", section.key);
        for (const Member& each : section.value.deleted)
            description.deleted.push_back(
                {each.key, each.key_place, memberPointer(pointer, each.key)});
    }
}

Status checkLimits(const Node& document, const Limits& limits)
{
    const std::pair<const char*, int> most[] = {{"passes", limits.passes},
                                                {"targets", limits.targets}};
    Diagnostics errors;
    for (const auto& [section, count] : most) {
        const Node* entries = document.find(section);
        if (!entries || static_cast<int>(entries->members.size()) <= count) continue;
        errors.push_back({Code::over_limit,
                          "the config has " + std::to_string(entries->members.size()) + " " +
                              section + ", and at most " + std::to_string(count) + " may be",
                          "leave some out, or raise Limits::" + std::string(section) +
                              " (--limit " + section + "=N)",
                          lastPlace(*entries), memberPointer("", section)});
    }
    return errors;
}

constexpr std::size_t kMaxSettings = 16384;  // of one feature; each takes some hundred bytes

using Level = FeatureDesc::Level;
using Setting = FeatureDesc::Setting;

void checkWord(const FeatureDesc& feature, const Reference& word, Report& report)
{
    if (contains(feature.values, word.name) || report.errorAt(feature.pointer + "/values")) return;
    report.at(word, Code::feature_value,
              "feature '" + feature.name + "' has no value '" + word.name + "'",
              suggestName(word.name, feature.values, "values"));
}

// Whether the config has a param or feature of that name; a warning where a swap took it away.
bool isDeclared(const std::vector<std::string>& names, const FeatureDesc& feature,
                const Setting& setting, Report& report)
{
    if (contains(names, setting.name)) return true;
    if (report.full()) return report.count(), false;
    Reported& error = report.at(
        setting, Code::unknown_param,
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
                 range(param->min, param->max, param->unit, isLength(*param)));
        return;
    }
    const FeatureDesc& other = *findNamed(description.features, setting.name);
    int index = 0;
    if (!other.sets.empty())
        report.at(
            setting, Code::cycle,
            "feature '" + feature.name + "' sets '" + other.name + "', which sets values itself",
            "let one of the two set everything");
    else if (!report.errorWithin(other.pointer))
        read(report, cursor, Choice{index, other.values, other.boolean}, {});
    setting.value[0] = static_cast<float>(index);
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

// Reads the values under `sets` of features, of which CV2105, CV2106, CV2107, CV2204, CV4004 and
// those of values are reported, and gives each word what any of them sets.
void readLevels(const Node& document, Description& description, Report& report)
{
    std::map<std::string, std::string> setters;  // features by what they set
    std::vector<std::string> declared = namesOf(description.params);
    for (const FeatureDesc& each : description.features) declared.push_back(each.name);
    for (FeatureDesc& feature : description.features) {
        std::map<std::string, Setting> names;
        for (Level& level : feature.sets) {
            checkWord(feature, level, report);
            auto& all = level.settings;
            eraseIf(all, [&](const Setting& each) {
                return !isDeclared(declared, feature, each, report);
            });
            for (Setting& each : all) {
                readValue(document, description, feature, each, report);
                names.emplace(each.name, each);
            }
        }
        if (names.empty()) continue;
        for (const std::string& word : feature.values)
            if (!findNamed(feature.sets, word))
                feature.sets.push_back({{{word, feature.place, feature.pointer}}, {}});
        if (feature.sets.size() * names.size() > kMaxSettings) {
            report.at(feature, Code::over_limit,
                      "feature '" + feature.name + "' has " + std::to_string(feature.sets.size()) +
                          " words that set " + std::to_string(names.size()) +
                          " values, more than " + std::to_string(kMaxSettings) + " together",
                      "let it set less, or have fewer words");
            continue;
        }
        for (const auto& [name, first] : names) {
            complete(description, feature, first);
            const auto [setter, fresh] = setters.emplace(name, feature.name);
            if (!fresh)
                report.at(first, Code::name_collision,
                          "features '" + setter->second + "' and '" + feature.name +
                              "' both set '" + name + "'",
                          "let one of the two set it");
        }
    }
}

}  // namespace

Cursor Cursor::child(const Member& member) const
{
    const std::string both = key.empty() ? member.key : key + " " + member.key;
    return {member.value, memberPointer(pointer, member.key), member.key_place, member.key, both,
            doc};
}

bool Report::leavesOut(const Place& key) const
{
    return document_.origins.size() > 1 && !(key.source && key.source->path == kOverridePath);
}

std::string Report::otherSection(const std::string& section, const std::string& name) const
{
    for (const std::string other : {"params", "features"}) {
        const Node* entries = other == section ? nullptr : document_.find(other);
        const Node* declared = entries ? entries->find(name) : nullptr;
        if (declared && declared->kind == Node::Kind::object)
            return "'" + name + "' is a " + other.substr(0, other.size() - 1) +
                   ": write it under " + other;
    }
    return {};
}

Reported& Report::atValue(const Cursor& cursor, Code code, std::string message, std::string help)
{
    return add({code, std::move(message), help.empty() ? cursor.doc : std::move(help),
                cursor.node.place, cursor.pointer, notesOf(cursor.node.origins)});
}

Reported& Report::atKey(const Cursor& cursor, Code code, std::string message, std::string help)
{
    return add({code, std::move(message), help.empty() ? cursor.doc : std::move(help),
                cursor.key_place, cursor.pointer});
}

Reported& Report::at(const Named& named, Code code, std::string message, std::string help,
                     const std::vector<Place>& origins)
{
    return add(
        {code, std::move(message), std::move(help), named.place, named.pointer, notesOf(origins)});
}

Reported& Report::add(Diagnostic diagnostic)
{
    if (errors_.size() == kMaxDiagnostics) {
        if (errors_.back().severity == Severity::error) dropped_ = std::move(errors_.back());
        errors_.pop_back();
        ++more_;
    }
    errors_.push_back({std::move(diagnostic)});
    return errors_.back();
}

bool Report::errorAt(std::string_view pointer) const
{
    return anyOf(errors_, [&](const Reported& each) { return each.pointer == pointer; });
}

bool Report::errorWithin(std::string_view pointer) const
{
    return anyOf(errors_, [&](const Reported& each) {
        return startsWith(each.pointer + "/", std::string(pointer) + "/");
    });
}

Diagnostics Report::take(const Node& document)
{
    if (dropped_) errors_.push_back(*std::move(dropped_));
    dropped_.reset();
    using Ordered = std::pair<std::vector<std::size_t>, Reported>;
    std::vector<Ordered> ordered;
    for (Reported& each : errors_)
        ordered.emplace_back(locate(document, each.pointer).path, std::move(each));
    errors_.clear();
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Ordered& a, const Ordered& b) { return a.first < b.first; });

    Diagnostics diagnostics;
    std::map<std::string, std::size_t> reported;  // mistakes, and their diagnostics
    for (auto& [path, error] : ordered) {
        const auto [first, fresh] = reported.emplace(error.mistake, diagnostics.size());
        if (!fresh && !error.mistake.empty()) {
            diagnostics[first->second].notes.push_back({error.place, "and here"});
            continue;
        }
        if (error.cause.source) blame(error, error.cause, "it is named here");
        diagnostics.push_back(std::move(error));
    }
    if (more_ > 0) diagnostics.back().notes.push_back(moreNote(std::size_t(more_)));
    return diagnostics;
}

Located locate(const Node& document, std::string_view pointer)
{
    Located located = {&document};
    for (const std::string& key : pointerKeys(pointer)) {
        if (!located.node) break;
        located.path.push_back(0);
        located.node = childAt(*located.node, key, located.path.back());
    }
    return located;
}

Reference referenceAt(const Node& document, const std::string& pointer)
{
    const Node& node = *locate(document, pointer).node;
    return {{node.text, node.place, pointer}, node.origins};
}

std::string numberText(double number) { return significant(number, 10); }

}  // namespace crevice::table

namespace crevice {

Result<Description> decode(const Node& document, const SourceSet& sources, const Limits& limits)
{
    using namespace table;
    if (const Status few = checkLimits(document, limits); !few) return few.diagnostics();
    Description description;
    description.limits = limits;
    description.place = document.place;
    noteDeleted(document, description);
    Report report(document, sources);
    read(report, Cursor{document, "", document.place}, description, {});
    checkNames(description, report);
    readLevels(document, description, report);
    std::set<std::string> referred;
    // What a misspelt section declares is not there, and all that refers to it would be reported.
    const auto misspelt = [&](const Member& each) {
        return each.value.kind == Node::Kind::object && report.errorAt("/" + each.key);
    };
    if (!anyOf(document.members, misspelt)) {
        referred = checkReferences(document, description, report);
        readShaderFiles(description, report);
    }
    Diagnostics diagnostics = report.take(document);
    if (hasErrors(diagnostics)) return diagnostics;
    for (const FeatureDesc& each : description.features) applyLevel(description, each.name);
    description.unused = std::move(diagnostics);  // of what is left out
    append(description.unused, unusedNames(document, description, std::move(referred)));
    cutShort(description.unused);
    return description;
}

}  // namespace crevice
