// SPDX-License-Identifier: MIT
// A run of a matrix: which cells are drawn, by how many processes, and what is known already.
#pragma once

#include "tools/measure/line_file.h"
#include "tools/measure/matrix/check.h"

namespace crevice {

struct RunMatrixOptions {
    CheckOptions check;
    int jobs = 1;         ///< Processes.
    bool resume = false;  ///< Cells that passed before, under the same key, are not drawn.
    std::string version = {};
    std::function<void(const std::string& what)> begin = {};  ///< A cell, or several.
};

struct MatrixRun {
    std::vector<CellResult> cells = {};  ///< In the matrix's order; those that were not begun lack.
    int kept = 0;                        ///< Of them, known already.
    bool interrupted = false;
};

/// Holds the plan's cells against their checks; each result is in OUT/cells.jsonl once it is there.
/// Results do not depend on the number of processes. What times is done last, by one process, when
/// no other draws. Opens no device before its processes are started.
///
/// Errors: CV7007.
Result<MatrixRun> runMatrix(const MatrixPlan& plan, const RunMatrixOptions& options);

}  // namespace crevice
