// SPDX-License-Identifier: MIT
// The report on bench results: one HTML file that needs no network, and its figures as JSON
// and CSV. The page is in tools/show/report.*; this puts the figures into it.
#pragma once

#include "tools/measure/bench/sample.h"

#include <string>
#include <vector>

namespace crevice {

/// The figures with what follows from them: views, Pareto fronts, advice, curves, failures.
std::string reportJson(const std::vector<BenchSample>& samples, const BenchCoverage& coverage = {});

/// One row a sample, failures too; RFC 4180 with a header row.
std::string reportCsv(const std::vector<BenchSample>& samples);

/// The page. Pictures are read from the paths in the samples and become part of it; one that cannot
/// be read is left out with a warning CV7005.
Result<std::string> reportHtml(const std::vector<BenchSample>& samples, bool with_pictures = true,
                               const BenchCoverage& coverage = {});

}  // namespace crevice
