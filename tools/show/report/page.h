// SPDX-License-Identifier: MIT
// Pages, put together at build from tools/show/report/bench.html, tools/show/report/stress.html and
// what those name.
#pragma once

#include <string_view>

namespace crevice {

/// Where in a page the figures go.
constexpr std::string_view kReportDataMark = "/*report.json*/";

std::string_view benchPage();
std::string_view stressPage();

}  // namespace crevice
