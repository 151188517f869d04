// SPDX-License-Identifier: MIT
#include "tools/measure/matrix/read_json.h"

#include "core/base/text.h"

namespace crevice {

void MatrixJson::fail(const Place& place, Code code, std::string message, std::string help)
{
    errors.push_back({code, std::move(message), std::move(help), place});
}

void MatrixJson::wrongType(const Node& node, const std::string& what, const std::string& wanted,
                           const std::string& help)
{
    fail(node.place, Code::wrong_type, what + ": found " + brief(node) + ", wanted " + wanted,
         help);
}

void MatrixJson::onlyKeys(const Node& object, const std::vector<std::string>& keys,
                          const std::string& of)
{
    for (const Member& member : object.members)
        if (!contains(keys, member.key))
            fail(member.key_place, Code::unknown_key, "'" + member.key + "' is no key of " + of,
                 suggestName(member.key, keys, "keys"));
}

const Node* MatrixJson::ofKind(const Node& object, const std::string& key, Kind kind)
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

MatrixWhere MatrixJson::readWhere(const Node& node, const std::string& key)
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
            fail(member.key_place, Code::reference_missing, "there is no axis '" + member.key + "'",
                 suggestName(member.key, namesOf(matrix.axes), "axes"));
            continue;
        }
        std::set<std::size_t>& values = where[axis];
        if (member.value.kind != Kind::array) addNamed(member.value, axis, values);
        for (const Node& item : member.value.items) addNamed(item, axis, values);
    }
    return where;
}

void MatrixJson::addNamed(const Node& node, int axis, std::set<std::size_t>& values)
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

}  // namespace crevice
