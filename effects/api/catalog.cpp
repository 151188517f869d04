// SPDX-License-Identifier: MIT
#include <crevice/shipped.h>

#include "effects/api/catalog_data.h"

#include <algorithm>

namespace crevice {
namespace {

constexpr std::string_view kConfigs = "configs/";

bool isConfig(std::string_view path) { return path.substr(0, kConfigs.size()) == kConfigs; }

/// One part of a checkout may link to another.
std::vector<std::string> withFolder(std::vector<std::string> roots, const std::string& folder)
{
    roots.push_back(folder);
    return roots;
}

}  // namespace

const SourceSet& shippedSources()
{
    static const MemorySources sources = [] {
        MemorySources filled;
        for (const CatalogEntry& entry : catalogEntries())
            filled.add(entry.path, std::string(entry.text, entry.size), entry.name);
        return filled;
    }();
    return sources;
}

CheckoutSources::CheckoutSources(std::string folder, std::vector<std::string> roots)
    : used_(!folder.empty()),
      effects_(folder + "/effects", withFolder(roots, folder)),
      configs_(folder + "/configs", withFolder(roots, folder))
{
}

SourceRef CheckoutSources::find(std::string_view path) const
{
    if (used_) {
        if (!isConfig(path)) {
            if (SourceRef module = effects_.find(path)) return module;
        } else if (const SourceRef found = configs_.find(fileOf(path.substr(kConfigs.size())))) {
            SourceText config = *found;
            config.path = path;  // by which configs are told from modules
            return std::make_shared<const SourceText>(std::move(config));
        }
    }
    return shippedSources().find(path);
}

// A config may lie in any folder of configs/; its name is its file's.
std::string CheckoutSources::fileOf(std::string_view name) const
{
    for (const std::string& path : configs_.list())
        if (path.substr(path.rfind('/') + 1) == name) return path;
    return std::string(name);
}

std::vector<std::string> CheckoutSources::list() const
{
    std::vector<std::string> paths = shippedSources().list();
    if (used_) {
        for (std::string& path : effects_.list()) paths.push_back(std::move(path));
        for (const std::string& path : configs_.list())
            paths.push_back(kConfigs.data() + path.substr(path.rfind('/') + 1));
    }
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

}  // namespace crevice
