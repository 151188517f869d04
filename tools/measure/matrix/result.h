// SPDX-License-Identifier: MIT
// What came of the cells of a matrix, and the files that say so to people and to other tools.
#pragma once

#include "tools/measure/matrix/matrix.h"

#include <nlohmann/json_fwd.hpp>

namespace crevice {

struct CheckResult {
    std::size_t check = 0;  ///< Into Matrix::checks.
    std::string title;
    /// "passed", "failed", "skipped"; of --approve "new", "changed" or "unchanged".
    std::string state = "passed";
    std::string text = {};  ///< What was found and what is allowed, or why it was not looked at.
    double time_s = 0;
    std::string got = {}, wanted = {}, difference = {};  ///< Pictures, seen from the results.
};

struct CellResult {
    std::size_t cell = 0;  ///< Into Matrix::cells.
    std::string key;       ///< Over all that decides it.
    std::vector<CheckResult> checks = {};

    bool is(const char* state) const;  ///< Whether any check is.
};

nlohmann::json toJson(const CellResult& result);
CellResult cellResultFrom(const nlohmann::json& json);  ///< May throw what nlohmann::json throws.

struct MatrixResults {
    const Matrix& matrix;
    std::vector<CellResult> cells;  ///< In the matrix's order.

    /// Checks of that state.
    int count(const char* state) const;
};

/// All results, for programs and for the page: no times, so that the same results are the same
/// text.
nlohmann::json resultsJson(const MatrixResults& results);

/// Test Anything Protocol 13, a point for each check.
std::string tapText(const MatrixResults& results);

/// JUnit's XML as build servers read it: a suite for each cell, a case for each check.
std::string junitXml(const MatrixResults& results);

}  // namespace crevice
