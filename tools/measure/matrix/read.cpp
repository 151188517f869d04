// SPDX-License-Identifier: MIT
// From a matrix file to a Matrix.
#include "tools/measure/matrix/keys.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/options.h"

#include <crevice/config.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace crevice {
namespace {

using Kind = Node::Kind;
using Words = std::vector<std::string>;

std::string inQuotes(const std::string& text) { return "'" + text + "'"; }

/// A text or a number, as names of values have it.
std::string plain(const Node& node) { return node.kind == Kind::string ? node.text : toJson(node); }

class MatrixReader {
public:
    MatrixReader(const std::string& file, const SourceSet& sources)
        : matrix{file},
          folder_(fs::path(file).parent_path()),
          sources_(sources)
    {
    }

    void readAll(const Node& document)
    {
        onlyKeys(document, topKeys(), "a matrix file");
        const Node* format = document.find("format");
        if (!format || format->kind != Kind::number || format->number != 1)
            fail(format ? format->place : document.place, Code::format_version,
                 format ? "the format " + brief(*format) + " of a matrix file is not known"
                        : "the matrix file has no 'format'",
                 "write \"format\": 1");
        for (const MatrixAxisKey& key : kAxisKeys) readAxis(document, key);
        if (const Node* params = ofKind(document, "params", Kind::object))
            for (const Member& param : params->members) readParam(param);
        const Node* folder = ofKind(document, "approved_folder", Kind::string);
        matrix.approved_folder =
            besideFile(folder ? folder->text : "approved/" + fs::path(matrix.file).stem().string());
        matrix.approved_format = readWord(document, "approved_format", {"png", "pfm"});
        matrix.pairwise = readWord(document, "combine", {"full", "pairwise"}) == "pairwise";
        if (hasErrors(errors)) return;  // the rest names axes and values
        double count = 1;
        for (const MatrixAxis& axis : matrix.axes) count *= static_cast<double>(axis.values.size());
        if (count > kMaxMatrixCells)
            fail(document.place, Code::over_limit,
                 "the axes have " + shortest(count) + " combinations, at most " +
                     std::to_string(kMaxMatrixCells) + " are laid out",
                 "split the file");
        if (const Node* cells = ofKind(document, "cells", Kind::array))
            for (const Node& item : cells->items) matrix.listed.push_back(readWhere(item, "cells"));
        if (!document.find("checks"))
            fail(document.place, Code::missing_key, "the matrix file has no 'checks'",
                 "write \"checks\": [{\"finite\": true}]");
        if (const Node* checks = ofKind(document, "checks", Kind::array))
            for (const Node& item : checks->items) readCheck(item);
    }

    Matrix matrix;
    Diagnostics errors;

private:
    void fail(const Place& place, Code code, std::string message, std::string help)
    {
        errors.push_back({code, std::move(message), std::move(help), place});
    }

    /// `what`: found the node, wanted something else.
    void wrongType(const Node& node, const std::string& what, const std::string& wanted,
                   const std::string& help)
    {
        fail(node.place, Code::wrong_type, what + ": found " + brief(node) + ", wanted " + wanted,
             help);
    }

    void onlyKeys(const Node& object, const Words& keys, const std::string& of)
    {
        for (const Member& member : object.members)
            if (!contains(keys, member.key))
                fail(member.key_place, Code::unknown_key,
                     inQuotes(member.key) + " is no key of " + of,
                     suggestName(member.key, keys, "keys"));
    }

    /// The member of that kind; null, with an error where there is one of another or an empty list.
    const Node* ofKind(const Node& object, const std::string& key, Kind kind)
    {
        const Node* node = object.find(key);
        if (node && node->kind == Kind::array && node->items.empty())
            fail(node->place, Code::bad_length, inQuotes(key) + " is empty", "name at least one");
        if (!node || node->kind == kind) return node;
        wrongType(*node, inQuotes(key), std::string("the kind ") + kindName(kind),
                  "docs/reference/matrix.md has an example");
        return nullptr;
    }

    /// The first of the words where there is none.
    std::string readWord(const Node& document, const char* key, const Words& words)
    {
        const Node* word = ofKind(document, key, Kind::string);
        if (word && !contains(words, word->text))
            fail(word->place, Code::bad_enum, inQuotes(key) + " cannot be " + inQuotes(word->text),
                 suggestName(word->text, words, "words"));
        return word ? word->text : words[0];
    }

    std::string besideFile(const std::string& path) const
    {
        return fs::path(path).is_absolute() || folder_.empty() ? path : (folder_ / path).string();
    }

    void readAxis(const Node& document, const MatrixAxisKey& key)
    {
        matrix.axes.push_back({key.axis, {}});
        std::vector<MatrixValue>& values = matrix.axes.back().values;
        const std::string example = std::string("write \"") + key.key + "\": [\"...\"]";
        const Node* node = document.find(key.key);
        if (!node && key.fallback)
            values.push_back({key.fallback, key.fallback, document.place});
        else if (!node)
            fail(document.place, Code::missing_key, "the matrix file has no " + inQuotes(key.key),
                 example);
        else if (matrix.axes.size() == kConfigAxis + 1 && node->text == "all")
            for (const std::string& name : configNames(sources_))
                values.push_back({name, name, node->place});
        else if (node->kind != Kind::array && node->kind != Kind::object)
            wrongType(*node, inQuotes(key.key), "a list or an object of texts", example);
        else if (node->items.empty() && node->members.empty())
            fail(node->place, Code::bad_length, inQuotes(key.key) + " is empty",
                 "name at least one, or leave the key out");
        if (!node) return;
        for (const Node& item : node->items) addValue(item.text, item, item.place);
        for (const Member& member : node->members)
            addValue(member.key, member.value, member.key_place);
    }

    /// To the last axis.
    void addValue(const std::string& name, const Node& node, const Place& place)
    {
        MatrixAxis& axis = matrix.axes.back();
        if (node.kind != Kind::string)
            return wrongType(node, "an entry of '" + axis.name + "s'", "a text",
                             "write it in quotes");
        if (findNamed(axis.values, name))
            return fail(place, Code::duplicate_key, inQuotes(name) + " is named twice",
                        "leave one out");
        axis.values.push_back({name, node.text, place});
        checkText(axis.values.back(), axis.name);
    }

    /// What can be known of a value by itself; files get their folder.
    void checkText(MatrixValue& value, const std::string& axis)
    {
        const auto known = [&](Code code, const Words& names) {
            if (!contains(names, value.text))
                fail(value.place, code, "there is no " + axis + " " + inQuotes(value.text),
                     suggestName(value.text, names, axis + "s"));
        };
        if (axis == "config" && has(value.text, ".json")) value.text = besideFile(value.text);
        if (axis == "backend") known(Code::bad_enum, {"egl", "osmesa"});
        if (axis == "scene" && isFileScene(value.text)) {
            value.text = besideFile(value.text);
            if (!fs::exists(value.text))
                fail(value.place, Code::scene_missing,
                     "there is no scene file " + inQuotes(value.text),
                     "files are looked for in the folder of the matrix file; built-in scenes: " +
                         joined(builtinSceneNames()));
        } else if (axis == "scene") {
            known(Code::scene_missing, builtinSceneNames());
        }
        if (axis != "size") return;
        if (const auto size = parseSize(value.text); !size)
            fail(value.place, Code::bad_size, size.diagnostics()[0].message, "write \"320x180\"");
    }

    void readParam(const Member& param)
    {
        if (findNamed(matrix.axes, param.key))
            return fail(param.key_place, Code::name_collision,
                        inQuotes(param.key) + " is an axis already",
                        "set it by a config that extends another");
        if (param.value.kind != Kind::array || param.value.items.empty())
            return wrongType(param.value, inQuotes(param.key), "a list of values",
                             "write \"radius\": [0.5, 1]");
        matrix.axes.push_back({param.key, {}});
        for (const Node& item : param.value.items)
            matrix.axes.back().values.push_back({plain(item), plain(item), item.place});
    }

    /// Axes and values by name.
    MatrixWhere readWhere(const Node& node, const std::string& key)
    {
        MatrixWhere where;
        if (node.kind != Kind::object || node.members.empty())
            wrongType(node, inQuotes(key), "an object of axes and values",
                      "write {\"config\": \"gtao\", \"scene\": [\"room\", \"street\"]}");
        for (const Member& member : node.members) {
            const int axis = indexOf(matrix.axes, member.key);
            if (axis < 0) {
                fail(member.key_place, Code::reference_missing,
                     "there is no axis " + inQuotes(member.key),
                     suggestName(member.key, namesOf(matrix.axes), "axes"));
                continue;
            }
            const bool list = member.value.kind == Kind::array;
            std::set<std::size_t>& found = where[axis];
            for (const Node& item : list ? member.value.items : std::vector<Node>{member.value}) {
                const std::vector<MatrixValue>& values = matrix.axes[axis].values;
                const int value = indexOf(values, plain(item));
                if (value >= 0)
                    found.insert(value);
                else
                    fail(item.place, Code::reference_missing,
                         "the axis " + inQuotes(member.key) + " has no value " +
                             inQuotes(plain(item)),
                         suggestName(plain(item), namesOf(values), "values"));
            }
        }
        return where;
    }

    void readCheck(const Node& node)
    {
        if (node.kind != Kind::object)
            return wrongType(node, "a check", "an object", "write {\"finite\": true}");
        onlyKeys(node, checkKeys(false), "a check");
        const Member* member = nullptr;
        int kinds = 0;
        for (const Member& each : node.members)
            if (contains(checkKeys(true), each.key)) member = &each, ++kinds;
        if (kinds != 1)
            return fail(node.place, kinds ? Code::name_collision : Code::missing_key,
                        kinds ? "a check has two kinds" : "a check has no kind",
                        "give it one of " + joined(checkKeys(true)));
        const int index = indexOf(kKinds, member->key);
        MatrixCheck check;
        check.kind = static_cast<CheckKind>(index);
        check.place = member->key_place;
        check.text = toJson(node);
        const Node* output = ofKind(node, "output", Kind::string);
        check.output = output ? output->text : check.kind == CheckKind::plan ? "" : "ao";
        check.title = member->key + (check.output.empty() ? "" : " " + check.output);
        if (const Node* where = node.find("where")) check.where = readWhere(*where, "where");
        readKind(member->value, kKinds[index], check);
        matrix.checks.push_back(std::move(check));
    }

    void readKind(const Node& node, const CheckKindKey& kind, MatrixCheck& check)
    {
        const std::string what = inQuotes(kind.name);
        if (kind.numbers.empty()) {
            if (!node.boolean) wrongType(node, what, "true", kind.help);
        } else if (kind.bare) {
            const std::vector<Node>& items = node.items;
            const bool list = kind.numbers.size() > 1;
            if (list && items.size() != kind.numbers.size())
                return wrongType(node, what, "a list of two numbers", kind.help);
            for (std::size_t i = 0; i < kind.numbers.size(); ++i)
                readNumber(list ? items[i] : node, kind, kind.numbers[i], check);
            if (check.has("low") && check.has("high") && check["low"] > check["high"])
                fail(node.place, Code::bad_range, "the range's low is above its high", kind.help);
        } else if (node.kind != Kind::object) {
            wrongType(node, what, "an object", kind.help);
        } else {
            readObject(node, kind, check);
        }
    }

    void readObject(const Node& node, const CheckKindKey& kind, MatrixCheck& check)
    {
        const std::string what = inQuotes(kind.name);
        onlyKeys(node, keysOf(kind), what);
        bool limits = false, limited = false;  // could have limits that may be left out; has one
        for (const CheckNumberKey& key : kind.numbers) {
            const Node* number = node.find(key.name);
            limits |= key.value == kNoLimit;
            limited |= number && key.value == kNoLimit;
            if (number)
                readNumber(*number, kind, key, check);
            else if (std::isnan(key.value))
                fail(node.place, Code::missing_key, what + " has no " + inQuotes(key.name),
                     kind.help);
            else if (key.value != kNoLimit)
                check.numbers[key.name] = key.value;
        }
        if (limits && !limited)
            fail(node.place, Code::missing_key, what + " sets no limit", kind.help);
        if (!kind.other) return;
        const Node* other = node.find(kind.other);
        if (!other)
            return fail(node.place, Code::missing_key, what + " has no " + inQuotes(kind.other),
                        kind.help);
        check.other = readWhere(*other, kind.other);
        if (anyOf(check.other, [](const auto& each) { return each.second.size() > 1; }))
            fail(other->place, Code::bad_length,
                 inQuotes(kind.other) + " names several values of one axis", "name one cell");
        if (check.kind == CheckKind::same && check.other.count(kSizeAxis) > 0)
            fail(other->place, Code::reference_missing, "pictures of two sizes cannot be the same",
                 "compare cells of one size");
    }

    void readNumber(const Node& node, const CheckKindKey& kind, const CheckNumberKey& key,
                    MatrixCheck& check)
    {
        const std::string what = inQuotes(kind.name) + " " + key.name;
        if (node.kind != Kind::number || (key.whole && !node.integer()))
            return wrongType(node, what, key.whole ? "a whole number" : "a number", kind.help);
        if (node.number < key.least || node.number > key.most)
            fail(node.place, Code::out_of_range,
                 what + " " + brief(node) + " is outside [" + shortest(key.least) + ", " +
                     shortest(key.most) + "]",
                 kind.help);
        check.numbers[key.name] = node.number;
    }

    const fs::path folder_;
    const SourceSet& sources_;
};

}  // namespace

Result<Matrix> readMatrix(const std::string& file, const SourceSet& sources)
{
    const SourceRef source = readFile(file);
    if (!source)
        return Diagnostic{Code::module_missing, "the matrix file '" + file + "' " + absenceOf(file),
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
