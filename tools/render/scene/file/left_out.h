// SPDX-License-Identifier: MIT
// What a scene's file has and crevice does not draw.
#pragma once

#include <crevice/diagnostic.h>

#include <set>

namespace crevice {

struct LeftOut {
    std::set<std::string> shape = {};  ///< Surfaces, or holes in them, are not as the file says.
    std::set<std::string> look = {};   ///< Their colours are not.

    bool any() const { return !shape.empty() || !look.empty(); }

    /// CV7010. Requires any().
    Diagnostic warning(const std::string& path) const;
};

/// Adds what a file of OBJ's materials says that is not read; other files have nothing of it.
void findLeftOutOfMtl(const std::string& file, LeftOut& left_out);

/// The keys of such a file, and those and the extensions of glTF, as tables in Markdown.
std::string mtlTable();
std::string gltfTables();

}  // namespace crevice
