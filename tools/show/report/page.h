// SPDX-License-Identifier: MIT
// Pages that hold their own figures and need no network.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace crevice {

/// The page with the model in the place of its mark "/*report.json*/". Every text becomes
/// printable, and none ends the script that it stands in.
std::string pageOf(std::string_view page, const nlohmann::json& model);

/// The page on a matrix's results, for resultsJson: what failed, with got, wanted, difference and a
/// slider that wipes from one to the other. Its pictures lie beside it.
std::string_view matrixPage();

}  // namespace crevice
