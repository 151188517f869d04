// SPDX-License-Identifier: MIT
// The report on bench results: one HTML file that needs no network, and its figures as CSV. The
// page is in tools/show/report/bench.html; this puts the figures into it.
#pragma once

#include "tools/measure/bench/sample.h"

#include <nlohmann/json_fwd.hpp>

namespace crevice {

/// What the page reads:
///
///     bench_samples  every bench sample as in the results, with its label and its title
///     views          what can be compared, by indexes of bench samples; `main` where it is its
///                    scene's first
///     advice         for each device, which configs to take over all of its scenes, by rising
///                    cost, and which do more harm than good
nlohmann::json reportModel(const std::vector<BenchSample>& samples);

/// One row a sample, failures too; RFC 4180 with a header row.
std::string reportCsv(const std::vector<BenchSample>& samples);

/// The page. Pictures are read from the paths in the samples and become part of it; one that cannot
/// be read is left out with a warning CV7005.
Result<std::string> reportHtml(const std::vector<BenchSample>& samples, bool with_pictures = true);

/// The page with the model in the place of its mark "/*report.json*/". Every text becomes
/// printable, and none ends the script that it stands in.
std::string pageOf(std::string_view page, const nlohmann::json& model);

/// The page on a matrix's results, for resultsJson: what failed, with got, wanted, difference and a
/// slider that wipes from one to the other. Its pictures lie beside it.
std::string_view matrixPage();

}  // namespace crevice
