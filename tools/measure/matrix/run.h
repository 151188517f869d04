// SPDX-License-Identifier: MIT
// A run of a matrix, what came of its cells, and the files that say so to people and to other
// tools.
#pragma once

#include "tools/measure/matrix/plan.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>

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
};

nlohmann::json toJson(const CellResult& result);
CellResult cellResultFrom(const nlohmann::json& json);  ///< May throw what nlohmann::json throws.

struct RunMatrixOptions {
    std::string out_folder;         ///< Pictures go to its pictures/.
    std::string cache_folder = {};  ///< For ground truths; empty for none.
    bool approve = false;           ///< Write approved files instead of judging.
    bool require_backends = false;  ///< A backend that cannot be had is a failure.
    int jobs = 1;                   ///< Processes.
    bool resume = false;  ///< Cells that passed before, under the same key, are not drawn.
    std::string version = {};
    std::function<void(const std::string& what)> begin = {};  ///< A cell, or several.
};

struct MatrixResults {
    const Matrix& matrix;
    std::vector<CellResult> cells = {};  ///< In the matrix's order; those not begun lack.
    std::size_t kept = 0;                ///< Of them, known already.
    bool interrupted = false;

    int count(std::string_view state) const;  ///< Checks of that state.
};

/// Looks at the checks that time, or at all others, of a cell by its index. What cannot be drawn
/// fails every check that needs it. Errors: CV7007 for pictures and approved files.
using CheckCell = std::function<Result<std::vector<CheckResult>>(std::size_t cell, bool times)>;

/// Keeps devices, scenes and pictures between cells. The plan and the options must outlive it.
CheckCell cellChecker(const MatrixPlan& plan, const RunMatrixOptions& options);

/// Holds the plan's cells against their checks; each result is in OUT/cells.jsonl once it is there.
/// Results do not depend on the number of processes. What times is done last, by one process, when
/// no other draws. Opens no device before its processes are started.
///
/// Errors: CV7007.
Result<MatrixResults> runMatrix(const MatrixPlan& plan, const RunMatrixOptions& options);

/// All results, for programs and for the page: no times, so that the same results are the same
/// text.
nlohmann::json resultsJson(const MatrixResults& results);

/// "3 passed, 1 failed": of the states that there are.
std::string countsOf(const MatrixResults& results);

/// Test Anything Protocol 13, a point for each check.
std::string tapText(const MatrixResults& results);

/// JUnit's XML as build servers read it: a suite for each cell, a case for each check.
std::string junitXml(const MatrixResults& results);

}  // namespace crevice
