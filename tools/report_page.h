// SPDX-License-Identifier: MIT
// The report's page, put together at build from tools/report.html and what it names.
#pragma once

#include <string_view>

namespace crevice {

/// Where in the page the figures go.
constexpr std::string_view kReportDataMark = "/*report.json*/";

std::string_view reportPage();

}  // namespace crevice
