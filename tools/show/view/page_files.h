// SPDX-License-Identifier: MIT
// The files of the built page. Only what its folder held when it was listed is ever read: what a
// browser asks for is looked up in that list and never made into a path.
#pragma once

#include <crevice/result.h>

#include <map>
#include <string>

namespace crevice {

class PageFiles {
public:
    /// Lists the folder, and folders in it; hidden files and links out of it are left out. Errors:
    /// CV7011 where it has no index.html.
    static Result<PageFiles> list(const std::string& folder);

    /// The path on disk of a file by its name in the page, "index.html", or null.
    const std::string* find(const std::string& name) const;

    std::size_t size() const { return paths_.size(); }

private:
    std::map<std::string, std::string> paths_;  // by name in the page
};

/// Where the page is: share/crevice/page beside the folder of this program, as it is installed, or
/// out/page of the source tree that it was built from. Empty where it is in neither.
std::string builtPageFolder();

/// By the extension of a file: "text/javascript; charset=utf-8".
const char* mimeType(const std::string& name);

}  // namespace crevice
