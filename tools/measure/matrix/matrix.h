// SPDX-License-Identifier: MIT
// What a matrix file says: axes of values, which of their combinations are cells, and what each
// cell is held against. docs/reference/matrix.md documents every key.
#pragma once

#include <crevice/diagnostic.h>
#include <crevice/document.h>

#include <map>
#include <set>

namespace crevice {

/// The axes that every matrix has, in this order; one for each of its `params` follows.
enum MatrixAxisIndex {
    kConfigAxis,
    kVariantAxis,
    kSceneAxis,
    kCameraAxis,
    kSizeAxis,
    kBackendAxis,
    kParamAxes
};

/// More combinations than anybody waits for.
constexpr std::size_t kMaxMatrixCells = 20000;

struct MatrixValue {
    std::string name;  ///< As cells are called by it; empty for none of an axis.
    std::string text;  ///< As options have it; files are seen from the current folder.
    Place place;
};

struct MatrixAxis {
    std::string name;  ///< "config", or a param's.
    std::vector<MatrixValue> values;
};

/// One value of each axis, by indexes.
using MatrixChoice = std::vector<std::size_t>;

/// Some values of some axes, by indexes; an axis that it does not have is free.
using MatrixWhere = std::map<std::size_t, std::set<std::size_t>>;

enum class CheckKind { approved, truth, same, plan, time, finite, range, background, open };

struct MatrixCheck {
    CheckKind kind;
    std::string title;                      ///< "approved ao", "plan".
    std::string output;                     ///< Empty for all of a plan.
    MatrixWhere where = {};                 ///< The cells that it is for.
    MatrixWhere other = {};                 ///< Of `same` and `time`: one value of what differs.
    std::map<std::string, double> numbers;  ///< Those given, and the defaults of others.
    Place place;
    std::string text;  ///< The check as JSON.

    bool has(const std::string& key) const { return numbers.count(key) > 0; }
    double operator[](const std::string& key) const { return numbers.at(key); }

    /// Whether it has an approved file.
    bool isApproved() const { return kind == CheckKind::approved || kind == CheckKind::plan; }
};

struct MatrixCell {
    MatrixChoice choice;
    std::string name;                      ///< "gtao, room, egl": of axes with several values.
    std::string file = {};                 ///< The same for files: "gtao-room-egl".
    std::string approved = {};             ///< That of its approved files, which backends share.
    std::vector<std::size_t> checks = {};  ///< Into Matrix::checks.
};

struct Matrix {
    std::string file;
    std::vector<MatrixAxis> axes = {};
    std::vector<MatrixCheck> checks = {};
    std::string approved_folder = {}, approved_format = "png";
    bool pairwise = false;
    std::vector<MatrixWhere> listed = {};  ///< Empty: all.
    std::vector<MatrixCell> cells = {};    ///< Neighbours share backend, scene, camera and size.

    const MatrixValue& value(const MatrixChoice& choice, std::size_t axis) const
    {
        return axes[axis].values[choice[axis]];
    }
};

/// Reads a matrix file and lays out its cells; "all" configs are those of `sources`.
///
/// Errors, each with its place and as many as there are: those of parseDocument; CV1201 for a file
/// that is not there; CV1207 for `format`; CV2102 for an axis or value that is not there; CV3001 to
/// CV3006 for keys and types; CV4001 and CV4005 for values; CV2108 for a check without a cell or a
/// cell without a check; CV2107 for cells whose files would have one name.
Result<Matrix> readMatrix(const std::string& file, const SourceSet& sources);

/// Lays out `cells` of a matrix that has all else. Errors: as above.
Diagnostics layOutCells(Matrix& matrix);

/// The cell that `same` or `time` compares with: the choice with other values of some axes.
MatrixChoice otherChoice(const MatrixCheck& check, MatrixChoice choice);

/// The name of any combination, as of cells.
std::string cellName(const Matrix& matrix, const MatrixChoice& choice);

}  // namespace crevice
