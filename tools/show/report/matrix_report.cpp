// SPDX-License-Identifier: MIT
#include "tools/show/report/matrix_report.h"

#include "tools/show/report/page.h"

#include <nlohmann/json.hpp>

namespace crevice {

std::string_view matrixPage();  // matrix.html and what it names, put together at build

std::string matrixHtml(const MatrixResults& results)
{
    return pageOf(matrixPage(), resultsJson(results));
}

}  // namespace crevice
