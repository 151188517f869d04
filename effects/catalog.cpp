// SPDX-License-Identifier: MIT
#include <crevice/shipped.h>

#include "effects/catalog_data.h"

namespace crevice {

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

}  // namespace crevice
