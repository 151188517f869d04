// SPDX-License-Identifier: MIT
// From a matrix file to a Matrix.
#include "tools/measure/matrix/matrix.h"

#include "core/base/text.h"
#include "tools/commands/cli/config_options.h"
#include "tools/measure/reference/tracer.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"

#include <cmath>
#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

/// The keys of axes, by MatrixAxisIndex: their axis's name and, where the file may leave them out,
/// their one value.
constexpr struct AxisKey {
    const char* key;
    const char* axis;
    const char* fallback;  ///< Null where the key must be there.
} kAxisKeys[] = {
    {"configs", "config", nullptr}, {"variants", "variant", ""}, {"sets", "set", ""},
    {"scenes", "scene", nullptr},   {"cameras", "camera", ""},   {"sizes", "size", "320x180"},
    {"backends", "backend", "egl"}};

constexpr double kNoLimit = INFINITY;

struct NumberKey {
    const char* name;
    double least, most;
    double value;  ///< Without it: NaN where it must be there, kNoLimit where nothing is then set.
};

/// The kinds of checks by CheckKind, and what stands in each.
const struct KindKey {
    const char* name;
    enum Shape { object, yes, number, pair } shape;
    std::vector<NumberKey> numbers;
    const char* other;  ///< The key that names another cell; null for none.
    const char* help;
} kKinds[] = {
    {"approved",
     KindKey::object,
     {{"max", 0, 1, kNoLimit}, {"share", 0, 1, 0}, {"flip", 0, 1, kNoLimit}},
     nullptr,
     "write {\"approved\": {\"max\": 0.01, \"share\": 0.001}} or {\"approved\": {\"flip\": 0.02}}"},
    {"truth",
     KindKey::object,
     {{"rmse", 0, 1, kNoLimit}, {"bias", 0, 1, kNoLimit}, {"rays", 1, kMaxTraceRays, 64}},
     nullptr,
     "write {\"truth\": {\"rmse\": 0.08, \"bias\": 0.02}}"},
    {"same",
     KindKey::object,
     {{"max", 0, 1, 0}, {"share", 0, 1, 0}},
     "as",
     "write {\"same\": {\"as\": {\"backend\": \"egl\"}, \"max\": 0.01}}"},
    {"plan", KindKey::yes, {}, nullptr, "write {\"plan\": true}"},
    {"time",
     KindKey::object,
     {{"most", 0, 1e6, NAN}},
     "over",
     "write {\"time\": {\"over\": {\"config\": \"learnopengl\"}, \"most\": 1.5}}"},
    {"finite", KindKey::yes, {}, nullptr, "write {\"finite\": true}"},
    {"range",
     KindKey::pair,
     {{"low", -1e30, 1e30, NAN}, {"high", -1e30, 1e30, NAN}},
     nullptr,
     "write {\"range\": [0, 1]}"},
    {"background",
     KindKey::number,
     {{"value", -1e30, 1e30, NAN}},
     nullptr,
     "write {\"background\": 1}"},
    {"open",
     KindKey::object,
     {{"least", 0, 1, NAN}, {"share", 0, 1, 0}, {"rays", 1, kMaxTraceRays, 64}},
     nullptr,
     "write {\"open\": {\"least\": 0.9, \"share\": 0.01}}"}};

std::vector<std::string> kindNames()
{
    return namesOf(std::vector<KindKey>(std::begin(kKinds), std::end(kKinds)));
}

std::vector<std::string> keysOf(const KindKey& kind)
{
    std::vector<std::string> keys = namesOf(kind.numbers);
    if (kind.other) keys.insert(keys.begin(), kind.other);
    return keys;
}

std::vector<std::string> checkKeys()
{
    std::vector<std::string> keys = kindNames();
    keys.insert(keys.end(), {"where", "output"});
    return keys;
}

std::vector<std::string> topKeys()
{
    std::vector<std::string> keys = {
        "format", "$schema", "params",          "combine",         "cells",
        "except", "checks",  "approved_folder", "approved_format", "approved_by_backend"};
    for (const AxisKey& each : kAxisKeys) keys.push_back(each.key);
    return keys;
}

class MatrixReader {
public:
    explicit MatrixReader(const std::string& file) : folder_(fs::path(file).parent_path())
    {
        matrix.file = file;
        matrix.approved_folder = besideFile("approved");
    }

    void readAll(const Node& document)
    {
        onlyKeys(document, topKeys(), "a matrix file");
        readFormat(document);
        for (const AxisKey& key : kAxisKeys) readAxis(document, key);
        if (const Node* params = ofKind(document, "params", Node::Kind::object))
            for (const Member& param : params->members) readParam(param);
        readApproved(document);
        if (hasErrors(errors)) return;  // the rest names axes and values
        readCombination(document);
        readChecks(document);
    }

    Matrix matrix;
    Diagnostics errors;

private:
    using Kind = Node::Kind;

    void fail(const Place& place, Code code, std::string message, std::string help)
    {
        errors.push_back({code, std::move(message), std::move(help), place});
    }

    void wrongType(const Node& node, const std::string& what, const std::string& wanted,
                   const std::string& help)
    {
        fail(node.place, Code::wrong_type, what + ": found " + brief(node) + ", wanted " + wanted,
             help);
    }

    void onlyKeys(const Node& object, const std::vector<std::string>& keys, const std::string& of)
    {
        for (const Member& member : object.members)
            if (!contains(keys, member.key))
                fail(member.key_place, Code::unknown_key, "'" + member.key + "' is no key of " + of,
                     suggestName(member.key, keys, "keys"));
    }

    /// The member of that kind; null, with an error where there is one of another.
    const Node* ofKind(const Node& object, const std::string& key, Kind kind)
    {
        const Node* node = object.find(key);
        if (!node || node->kind == kind) return node;
        const char* const example = kind == Kind::object    ? "{...}"
                                    : kind == Kind::array   ? "[...]"
                                    : kind == Kind::boolean ? "true"
                                                            : "\"...\"";
        wrongType(*node, "'" + key + "'", std::string("the kind ") + kindName(kind),
                  "write \"" + key + "\": " + example);
        return nullptr;
    }

    std::string besideFile(const std::string& path) const
    {
        return fs::path(path).is_absolute() || folder_.empty() ? path : (folder_ / path).string();
    }

    void readFormat(const Node& document)
    {
        const Node* format = document.find("format");
        if (format && format->kind == Kind::number && format->number == 1) return;
        fail(format ? format->place : document.place, Code::format_version,
             format ? "the format " + brief(*format) + " of a matrix file is not known"
                    : "the matrix file has no 'format'",
             "write \"format\": 1");
    }

    // --- axes ---

    void readAxis(const Node& document, const AxisKey& key)
    {
        MatrixAxis axis{key.axis, {}};
        const Node* values = document.find(key.key);
        if (!values && key.fallback)
            axis.values.push_back({key.fallback, key.fallback, {}, document.place});
        else if (!values)
            fail(document.place, Code::missing_key,
                 std::string("the matrix file has no '") + key.key + "'",
                 std::string("write \"") + key.key + "\": [\"...\"]");
        else
            readValues(*values, key, axis);
        matrix.axes.push_back(std::move(axis));
    }

    void readValues(const Node& values, const AxisKey& key, MatrixAxis& axis)
    {
        const bool sets = std::string_view(key.key) == "sets";
        if (values.kind == Kind::array && !sets) {
            for (const Node& item : values.items) addValue(item.text, item, item.place, key, axis);
        } else if (values.kind == Kind::object) {
            for (const Member& member : values.members)
                addValue(member.key, member.value, member.key_place, key, axis);
        } else {
            return wrongType(values, std::string("'") + key.key + "'",
                             sets ? "an object of lists" : "a list or an object of texts",
                             sets ? "write \"sets\": {\"wide\": [\"radius=1\"]}"
                                  : std::string("write \"") + key.key + "\": [\"...\"]");
        }
        if (axis.values.empty())
            fail(values.place, Code::bad_length, std::string("'") + key.key + "' is empty",
                 "name at least one, or leave the key out");
    }

    void addValue(const std::string& name, const Node& node, const Place& place, const AxisKey& key,
                  MatrixAxis& axis)
    {
        MatrixValue value{name, node.text, {}, place};
        const std::string what = std::string("an entry of '") + key.key + "'";
        if (std::string_view(key.key) == "sets") {
            if (node.kind != Kind::array ||
                anyOf(node.items, [](const Node& item) { return item.kind != Kind::string; }))
                return wrongType(node, what, "a list of texts",
                                 "write [\"radius=1\", \"steps=4\"]");
            for (const Node& item : node.items) value.overrides.push_back(item.text);
        } else if (node.kind != Kind::string) {
            return wrongType(node, what, "a text", "write it in quotes");
        }
        if (anyOf(axis.values, [&](const MatrixValue& each) { return each.name == name; }))
            return fail(place, Code::duplicate_key, "'" + name + "' is named twice",
                        "leave one out");
        checkText(value, key.axis);
        axis.values.push_back(std::move(value));
    }

    /// What can be known of a value by itself; files get their folder.
    void checkText(MatrixValue& value, std::string_view axis)
    {
        if (axis == "config" && has(value.text, ".json")) value.text = besideFile(value.text);
        if (axis == "scene" && isFileScene(value.text)) value.text = besideFile(value.text);
        if (axis == "scene" && isFileScene(value.text) && !fs::exists(value.text))
            fail(value.place, Code::scene_missing, "there is no scene file '" + value.text + "'",
                 "files are looked for in the folder of the matrix file; built-in scenes: " +
                     joined(builtinSceneNames()));
        else if (axis == "scene" && !isFileScene(value.text) &&
                 !contains(builtinSceneNames(), value.text))
            fail(value.place, Code::scene_missing, "there is no scene '" + value.text + "'",
                 suggestName(value.text, builtinSceneNames(), "built-in scenes"));
        if (axis == "size")
            if (const auto size = parseSize(value.text); !size)
                fail(value.place, Code::bad_size, size.diagnostics()[0].message,
                     "write \"320x180\"");
        if (axis == "backend" && value.text != "egl" && value.text != "osmesa")
            fail(value.place, Code::bad_enum, "there is no backend '" + value.text + "'",
                 suggestName(value.text, {"egl", "osmesa"}, "backends"));
    }

    void readParam(const Member& param)
    {
        MatrixAxis axis{param.key, {}};
        const bool taken =
            anyOf(matrix.axes, [&](const MatrixAxis& a) { return a.name == param.key; });
        if (taken)
            return fail(param.key_place, Code::name_collision,
                        "'" + param.key + "' is an axis already", "set it by `sets`");
        if (param.value.kind != Kind::array || param.value.items.empty())
            return wrongType(param.value, "'" + param.key + "'", "a list of values",
                             "write \"radius\": [0.5, 1]");
        for (const Node& item : param.value.items) {
            const std::string name = item.kind == Kind::string ? item.text : toJson(item);
            axis.values.push_back({name, name, {param.key + "=" + name}, item.place});
        }
        matrix.axes.push_back(std::move(axis));
    }

    void readApproved(const Node& document)
    {
        if (const Node* folder = ofKind(document, "approved_folder", Kind::string))
            matrix.approved_folder = besideFile(folder->text);
        if (const Node* each = ofKind(document, "approved_by_backend", Kind::boolean))
            matrix.approved_by_backend = each->boolean;
        const Node* format = ofKind(document, "approved_format", Kind::string);
        if (!format) return;
        matrix.approved_format = format->text;
        if (format->text != "png" && format->text != "pfm")
            fail(format->place, Code::bad_enum,
                 "there is no approved_format '" + format->text + "'",
                 suggestName(format->text, {"pfm", "png"}, "formats"));
    }

    // --- which combinations ---

    void readCombination(const Node& document)
    {
        double count = 1;
        for (const MatrixAxis& axis : matrix.axes) count *= static_cast<double>(axis.values.size());
        if (count > kMaxMatrixCells)
            fail(document.place, Code::over_limit,
                 "the axes have " + shortest(count) + " combinations, at most " +
                     std::to_string(kMaxMatrixCells) + " are laid out",
                 "split the file");
        const Node* combine = ofKind(document, "combine", Kind::string);
        if (combine && combine->text != "full" && combine->text != "pairwise")
            fail(combine->place, Code::bad_enum, "'combine' cannot be '" + combine->text + "'",
                 suggestName(combine->text, {"full", "pairwise"}, "ways"));
        matrix.pairwise = combine && combine->text == "pairwise";
        readList(document, "cells", matrix.listed);
        readList(document, "except", matrix.except);
    }

    void readList(const Node& document, const char* key, std::vector<MatrixWhere>& list)
    {
        const Node* node = ofKind(document, key, Kind::array);
        if (!node) return;
        if (node->items.empty())
            fail(node->place, Code::bad_length, std::string("'") + key + "' is empty",
                 "leave the key out");
        for (const Node& item : node->items) list.push_back(readWhere(item, key));
    }

    MatrixWhere readWhere(const Node& node, const std::string& key)
    {
        MatrixWhere where;
        if (node.kind != Kind::object || node.members.empty()) {
            wrongType(node, "'" + key + "'", "an object of axes and values",
                      "write {\"config\": \"gtao\", \"scene\": [\"room\", \"street\"]}");
            return where;
        }
        for (const Member& member : node.members) {
            const int axis = indexOf(matrix.axes, member.key);
            if (axis < 0) {
                fail(member.key_place, Code::reference_missing,
                     "there is no axis '" + member.key + "'",
                     suggestName(member.key, namesOf(matrix.axes), "axes"));
                continue;
            }
            std::set<std::size_t>& values = where[axis];
            if (member.value.kind != Kind::array) addNamed(member.value, axis, values);
            for (const Node& item : member.value.items) addNamed(item, axis, values);
        }
        return where;
    }

    void addNamed(const Node& node, int axis, std::set<std::size_t>& values)
    {
        const std::vector<MatrixValue>& known = matrix.axes[axis].values;
        const std::string name = node.kind == Kind::string ? node.text : toJson(node);
        const int value = indexOf(known, name);
        if (value >= 0)
            values.insert(value);
        else
            fail(node.place, Code::reference_missing,
                 "the axis '" + matrix.axes[axis].name + "' has no value '" + name + "'",
                 suggestName(name, namesOf(known), "values"));
    }

    // --- checks ---

    void readChecks(const Node& document)
    {
        const Node* checks = ofKind(document, "checks", Kind::array);
        if (!document.find("checks") || (checks && checks->items.empty()))
            fail(checks ? checks->place : document.place, Code::missing_key,
                 "the matrix file has no 'checks'", "write \"checks\": [{\"finite\": true}]");
        if (!checks) return;
        for (const Node& item : checks->items) readCheck(item);
    }

    void readCheck(const Node& node)
    {
        if (node.kind != Kind::object)
            return wrongType(node, "a check", "an object", "write {\"finite\": true}");
        onlyKeys(node, checkKeys(), "a check");
        const Member* kind = nullptr;
        int kinds = 0;
        for (const Member& member : node.members)
            if (contains(kindNames(), member.key)) kind = &member, ++kinds;
        if (kinds != 1)
            return fail(node.place, kinds ? Code::name_collision : Code::missing_key,
                        kinds ? "a check has two kinds" : "a check has no kind",
                        "give it one of " + joined(kindNames()));
        MatrixCheck check;
        check.place = kind->key_place;
        check.text = toJson(node);
        check.kind = static_cast<CheckKind>(
            std::find_if(std::begin(kKinds), std::end(kKinds),
                         [&](const KindKey& each) { return each.name == kind->key; }) -
            kKinds);
        if (const Node* output = ofKind(node, "output", Kind::string)) check.output = output->text;
        if (node.find("output") && check.kind == CheckKind::plan)
            check.text += check.output;
        else if (check.kind == CheckKind::plan)
            check.output.clear();
        if (const Node* where = node.find("where")) check.where = readWhere(*where, "where");
        readKind(kind->value, kKinds[static_cast<int>(check.kind)], check);
        matrix.checks.push_back(std::move(check));
    }

    void readKind(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        const std::string what = std::string("'") + kind.name + "'";
        switch (kind.shape) {
        case KindKey::yes:
            if (!node.boolean) wrongType(node, what, "true", kind.help);
            return;
        case KindKey::number: return readNumber(node, kind, kind.numbers[0], check);
        case KindKey::pair:
            if (node.kind != Kind::array || node.items.size() != 2)
                return wrongType(node, what, "a list of two numbers", kind.help);
            for (std::size_t i = 0; i < 2; ++i)
                readNumber(node.items[i], kind, kind.numbers[i], check);
            if (check.has("low") && check.has("high") && !(check["low"] <= check["high"]))
                fail(node.place, Code::bad_range, "the range's low is above its high", kind.help);
            return;
        case KindKey::object:
            if (node.kind != Kind::object) return wrongType(node, what, "an object", kind.help);
            readObject(node, kind, check);
        }
    }

    void readObject(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        onlyKeys(node, keysOf(kind), std::string("'") + kind.name + "'");
        bool limits = false, limited = false;  // could have limits that may be left out; has one
        for (const NumberKey& key : kind.numbers) {
            const Node* number = node.find(key.name);
            limits |= key.value == kNoLimit;
            limited |= number && key.value == kNoLimit;
            if (number)
                readNumber(*number, kind, key, check);
            else if (std::isnan(key.value))
                fail(node.place, Code::missing_key,
                     std::string("'") + kind.name + "' has no '" + key.name + "'", kind.help);
            else if (key.value != kNoLimit)
                check.numbers[key.name] = key.value;
        }
        if (limits && !limited)
            fail(node.place, Code::missing_key, std::string("'") + kind.name + "' sets no limit",
                 kind.help);
        if (kind.other) readOther(node, kind, check);
    }

    void readNumber(const Node& node, const KindKey& kind, const NumberKey& key, MatrixCheck& check)
    {
        const std::string what = std::string("'") + kind.name + "' " + key.name;
        if (node.kind != Kind::number) return wrongType(node, what, "a number", kind.help);
        if (!(node.number >= key.least && node.number <= key.most))
            fail(node.place, Code::out_of_range,
                 what + " " + brief(node) + " is outside [" + shortest(key.least) + ", " +
                     shortest(key.most) + "]",
                 kind.help);
        check.numbers[key.name] = node.number;
    }

    void readOther(const Node& node, const KindKey& kind, MatrixCheck& check)
    {
        const Node* other = node.find(kind.other);
        if (!other)
            return fail(node.place, Code::missing_key,
                        std::string("'") + kind.name + "' has no '" + kind.other + "'", kind.help);
        check.other = readWhere(*other, kind.other);
        if (anyOf(check.other, [](const auto& each) { return each.second.size() > 1; }))
            fail(other->place, Code::bad_length,
                 std::string("'") + kind.other + "' names several values of one axis",
                 "name one cell");
        const bool resized = check.other.count(kSizeAxis) > 0;
        if (resized && check.kind == CheckKind::same)
            fail(other->place, Code::reference_missing, "pictures of two sizes cannot be the same",
                 "compare cells of one size");
    }

    const fs::path folder_;
};

}  // namespace

std::string MatrixCheck::title() const
{
    const std::string name = kKinds[static_cast<int>(kind)].name;
    return output.empty() ? name : name + " " + output;
}

std::vector<MatrixKey> matrixKeys()
{
    std::vector<MatrixKey> all;
    for (const std::string& key : topKeys()) all.push_back({"", key});
    for (const std::string& key : checkKeys()) all.push_back({"checks", key});
    for (const KindKey& kind : kKinds)
        if (kind.shape == KindKey::object)
            for (const std::string& key : keysOf(kind)) all.push_back({kind.name, key});
    return all;
}

Result<Matrix> readMatrix(const std::string& file)
{
    const SourceRef source = readFile(file);
    if (!source)
        return Diagnostic{Code::module_missing, "there is no matrix file '" + file + "'",
                          "write crevice test FILE.json; docs/reference/matrix.md has an example"};
    const Result<Node> document = parseDocument(source);
    if (!document) return document.diagnostics();
    MatrixReader reader(file);
    reader.readAll(*document);
    if (!hasErrors(reader.errors)) reader.errors = layOutCells(reader.matrix);
    cutShort(reader.errors);
    if (hasErrors(reader.errors)) return reader.errors;
    return std::move(reader.matrix);
}

}  // namespace crevice
