// SPDX-License-Identifier: MIT
// From a matrix file to a Matrix: axes, and which combinations there are.
#include "tools/measure/matrix/read_json.h"

#include "core/base/text.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"

#include <crevice/config.h>

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

std::vector<std::string> topKeys()
{
    std::vector<std::string> keys = {
        "format", "$schema", "params",          "combine",         "cells",
        "except", "checks",  "approved_folder", "approved_format", "approved_by_backend"};
    for (const AxisKey& each : kAxisKeys) keys.push_back(each.key);
    return keys;
}

class MatrixReader : public MatrixJson {
public:
    MatrixReader(const std::string& file, const SourceSet& sources)
        : folder_(fs::path(file).parent_path()),
          sources_(sources)
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
        readChecks(*this, document);
    }

private:
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
        const bool all = std::string_view(key.key) == "configs" && values.text == "all";
        if (all)
            for (const std::string& name : configNames(sources_))
                axis.values.push_back({name, name, {}, values.place});
        if (values.kind == Kind::array && !sets) {
            for (const Node& item : values.items) addValue(item.text, item, item.place, key, axis);
        } else if (values.kind == Kind::object) {
            for (const Member& member : values.members)
                addValue(member.key, member.value, member.key_place, key, axis);
        } else if (!all) {
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

    const fs::path folder_;
    const SourceSet& sources_;
};

}  // namespace

std::vector<MatrixKey> matrixKeys()
{
    std::vector<MatrixKey> all = checkKeys();
    for (const std::string& key : topKeys()) all.push_back({"", key});
    return all;
}

Result<Matrix> readMatrix(const std::string& file, const SourceSet& sources)
{
    const SourceRef source = readFile(file);
    if (!source)
        return Diagnostic{Code::module_missing, "there is no matrix file '" + file + "'",
                          "write crevice test FILE.json; docs/reference/matrix.md has an example"};
    const Result<Node> document = parseDocument(source);
    if (!document) return document.diagnostics();
    MatrixReader reader(file, sources);
    reader.readAll(*document);
    if (!hasErrors(reader.errors)) reader.errors = layOutCells(reader.matrix);
    cutShort(reader.errors);
    if (hasErrors(reader.errors)) return reader.errors;
    return std::move(reader.matrix);
}

}  // namespace crevice
