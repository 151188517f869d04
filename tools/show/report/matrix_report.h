// SPDX-License-Identifier: MIT
// The page on a matrix's results: what failed, with got, wanted and difference, and a slider that
// wipes from one to the other. Its pictures lie beside it.
#pragma once

#include "tools/measure/matrix/result.h"

namespace crevice {

/// The page is in tools/show/report/matrix.html.
std::string matrixHtml(const MatrixResults& results);

}  // namespace crevice
