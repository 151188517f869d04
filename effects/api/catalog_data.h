// SPDX-License-Identifier: MIT
// What embed.cmake generates: one entry a file.
#pragma once

#include <cstddef>
#include <vector>

namespace crevice {

struct CatalogEntry {
    const char* path;  ///< As modules and shaders name it.
    const char* name;  ///< As messages name it: the path in a checkout.
    const char* text;
    std::size_t size;
};

const std::vector<CatalogEntry>& catalogEntries();

}  // namespace crevice
