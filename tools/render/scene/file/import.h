// SPDX-License-Identifier: MIT
// Scenes from files, in this process; what `importScene` runs in one of its own.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// What a message may suggest instead of a file that cannot be read.
constexpr const char* kSceneFormats = "scenes are glTF 2.0 (.gltf, .glb), OBJ, PLY, STL or 3DS";

/// Whether the file's extension is that of a format that is read unless any is asked for.
bool isDefaultFormat(const std::string& path);

/// CV7002.
Diagnostic brokenScene(const std::string& path, const std::string& reason,
                       std::string help = kSceneFormats);

/// Requires a regular file. Throws what Assimp throws; Assimp may assert, crash, hang or fill the
/// memory. Errors: CV7002, CV7003.
Result<Scene> readScene(const std::string& path, const ImportOptions& options);

}  // namespace crevice
