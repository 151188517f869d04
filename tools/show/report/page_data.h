// SPDX-License-Identifier: MIT
// Putting figures and pictures into a page, so that it needs no other file.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace crevice {

/// A PNG as text that an <img> shows; empty where the file cannot be read, is no PNG, or lies
/// outside of the folder once links are resolved.
std::string pictureUri(const std::string& path, const std::string& folder);

/// The page with the data in the place of kReportDataMark, so written that "</script>" in it ends
/// nothing. Its texts are made printable.
std::string pageWith(std::string_view page, const nlohmann::json& data);

}  // namespace crevice
