// SPDX-License-Identifier: MIT
// The files of the built page. Only what its folder held when it was listed is ever read: what a
// browser asks for is looked up in that list and never made into a path.
#pragma once

#include <crevice/diagnostic.h>

namespace crevice {

/// Paths on disk by names in the page, such as "index.html".
using PageFiles = std::map<std::string, std::string>;

/// Lists the folder, and folders in it; hidden files and links out of it are left out. Errors:
/// CV7011 where it has no index.html.
Result<PageFiles> listPage(const std::string& folder);

/// Where the page is: share/crevice/page beside the folder of this program, as it is installed, or
/// out/page of the source tree that it was built from. Empty where it is in neither.
std::string builtPageFolder();

}  // namespace crevice
