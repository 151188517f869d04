// SPDX-License-Identifier: MIT
// A page has no files to read scenes from.
#include "tools/render/scene/scene.h"

namespace crevice {

Result<Scene> importScene(const std::string& path, const ImportOptions&)
{
    return Diagnostic{Code::scene_missing, "a page reads no file '" + path + "'",
                      "serve it by crevice view --scene FILE"};
}

}  // namespace crevice
