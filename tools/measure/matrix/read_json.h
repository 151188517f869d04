// SPDX-License-Identifier: MIT
// What the readers of a matrix file share: the matrix so far, and errors with their places.
#pragma once

#include "tools/measure/matrix/matrix.h"

namespace crevice {

class MatrixJson {
public:
    using Kind = Node::Kind;

    void fail(const Place& place, Code code, std::string message, std::string help);

    /// `what`: found the node, wanted something else.
    void wrongType(const Node& node, const std::string& what, const std::string& wanted,
                   const std::string& help);

    /// Reports keys that are none of these.
    void onlyKeys(const Node& object, const std::vector<std::string>& keys, const std::string& of);

    /// The member of that kind; null, with an error where there is one of another.
    const Node* ofKind(const Node& object, const std::string& key, Kind kind);

    /// Axes and values by name. Requires all axes.
    MatrixWhere readWhere(const Node& node, const std::string& key);

    Matrix matrix;
    Diagnostics errors;

private:
    void addNamed(const Node& node, int axis, std::set<std::size_t>& values);
};

/// The checks of a document, once its axes are known.
void readChecks(MatrixJson& json, const Node& document);

/// The keys of checks, and those in each kind.
std::vector<MatrixKey> checkKeys();

}  // namespace crevice
