// SPDX-License-Identifier: MIT
// Putting figures and pictures into a page, so that it needs no other file.
#pragma once

#include <string>
#include <string_view>

namespace crevice {

/// A PNG as text that an <img> shows; empty where the file cannot be read.
std::string pictureUri(const std::string& path);

/// The page with JSON in the place of kReportDataMark, so written that "</script>" in it ends nothing.
std::string pageWith(std::string_view page, std::string_view json);

}  // namespace crevice
