// SPDX-License-Identifier: MIT
// The page of bench results, put together at build from tools/show/report/bench.html and what it
// names.
#pragma once

#include <string_view>

namespace crevice {

/// Where in a page the figures go.
constexpr std::string_view kReportDataMark = "/*report.json*/";

std::string_view benchPage();

}  // namespace crevice
