// SPDX-License-Identifier: MIT
#include "tools/show/view/page_files.h"

#include "core/base/files.h"
#include "core/base/text.h"

#include <filesystem>

namespace crevice {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;  // of a folder that is no page, such as one's home

bool isPage(const fs::path& folder)
{
    std::error_code error;
    return fs::is_regular_file(folder / "index.html", error);
}

}  // namespace

Result<PageFiles> listPage(const std::string& folder)
{
    if (folder.empty() || !isPage(folder))
        return Diagnostic{Code::page_missing,
                          folder.empty() ? "the page is not built"
                                         : "the folder '" + folder + "' has no index.html",
                          "build the page with tools/page.sh, or name its folder with --page"};
    PageFiles files;
    std::error_code error;
    fs::recursive_directory_iterator entries(folder, error);
    for (const fs::recursive_directory_iterator end; !error && entries != end;
         entries.increment(error)) {
        const fs::path& path = entries->path();
        std::error_code unreadable;
        if (startsWith(path.filename().string(), ".")) {
            entries.disable_recursion_pending();
            continue;
        }
        if (!entries->is_regular_file(unreadable) || !isBelow(path.string(), {folder})) continue;
        files[path.lexically_relative(folder).generic_string()] = path.string();
        if (files.size() == kMostFiles) break;
    }
    files["index.html"] = (fs::path(folder) / "index.html").string();
    return files;
}

std::string builtPageFolder()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path().parent_path() / "share/crevice/page";
    if (!error && isPage(installed)) return installed.string();
    return isPage(CREVICE_PAGE_FOLDER) ? CREVICE_PAGE_FOLDER : "";
}

}  // namespace crevice
