// SPDX-License-Identifier: MIT
// The text of tools/report.html, report.css, report_chart.js and report.js, embedded at build.
#pragma once

#include <string_view>

namespace crevice {

std::string_view reportPage();
std::string_view reportStyle();
std::string_view reportChartScript();
std::string_view reportScript();

}  // namespace crevice
