// SPDX-License-Identifier: MIT
#include "tools/show/view/source_paths.h"

#include "core/base/text.h"

namespace crevice {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kConfigFolder = "configs/";
constexpr std::string_view kJsonSuffix = ".json";

// Links stay, since names are resolved without them.
fs::path absolutePath(const fs::path& path)
{
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

fs::path commonFolder(const fs::path& one, const fs::path& other)
{
    fs::path common;
    for (auto a = one.begin(), b = other.begin(); a != one.end() && b != other.end(); ++a, ++b) {
        if (*a != *b) break;
        common /= *a;
    }
    return common;
}

// Whether a file of the folder is named like one of the shipped configs.
bool hidesShipped(const fs::path& folder, const SourceSet& shipped)
{
    std::error_code error;
    for (const std::string& path : shipped.list())
        if (startsWith(path, kConfigFolder) &&
            fs::exists(folder / path.substr(kConfigFolder.size()), error))
            return true;
    return false;
}

}  // namespace

SourcePaths::SourcePaths(const std::string& config_file, const std::vector<std::string>& roots,
                         const SourceSet& shipped)
    : shipped_(shipped)
{
    const fs::path config = absolutePath(config_file);
    top_ = config.parent_path();
    for (const std::string& root : roots) top_ = commonFolder(top_, absolutePath(root));
    if (hidesShipped(top_, shipped)) folder_ += "mine/";
    config_name_ = of(config_file).substr(kConfigFolder.size());
    config_name_.resize(config_name_.size() - kJsonSuffix.size());
}

std::string SourcePaths::of(const std::string& file) const
{
    const std::string below = absolutePath(file).lexically_relative(top_).generic_string();
    if (below.empty() || below == "." || startsWith(below, "..")) return "";
    const std::string path = folder_ + below;
    return shipped_.find(path) ? "" : path;
}

}  // namespace crevice
