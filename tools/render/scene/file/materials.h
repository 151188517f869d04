// SPDX-License-Identifier: MIT
// Materials and textures of an Assimp scene; the part of the import that reads image files.
#pragma once

#include "tools/render/scene/scene.h"

struct aiScene;

namespace crevice {

class SceneFolder;

/// Appends a material for each of `from`'s, in its order, and the base-colour textures that they
/// use, each once. `path` is the scene file's: textures are looked for beside it. One that is
/// missing or broken is left out, with a warning CV7005; one that `folder` does not open, without.
void importMaterials(const aiScene& from, const std::string& path, SceneFolder& folder,
                     Scene& scene, Diagnostics& warnings);

}  // namespace crevice
