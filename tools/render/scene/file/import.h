// SPDX-License-Identifier: MIT
// Scenes from files, in this process; what `importScene` runs in one of its own, and its parts.
#pragma once

#include "tools/render/scene/scene.h"

struct aiScene;

namespace crevice {

class SceneFolder;

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

/// Appends a material for each of `from`'s, in its order, and the base-colour textures that they
/// use, each once. `path` is the scene file's: textures are looked for beside it. One that is
/// missing or broken is left out, with a warning CV7005; one that `folder` does not open, without.
void importMaterials(const aiScene& from, const std::string& path, SceneFolder& folder,
                     Scene& scene, Diagnostics& warnings);

/// world_from_node by node name: Assimp's cameras and lights stand where the node of their name is.
using NodePlaces = std::map<std::string, glm::dmat4>;

/// By the file's extension.
bool isGltf(const std::string& path);

/// Appends all cameras. `path` is the scene file's; its extension says whether it is glTF.
void importCameras(const aiScene& from, const std::string& path, const NodePlaces& places,
                   Scene& scene);

/// Turns closed surfaces that are inside out, winding and normals, and returns how many. A room
/// that is seen from inside is no such surface: a camera, or the centre of another surface's box,
/// is in its box.
std::size_t turnInsideOut(Scene& scene);

/// Appends point, spot and directional lights. Files give candela, lux, watts or plain fractions;
/// here a colour is what arrives at the centre of the scene, relative to what the brightest light
/// brings there (whose largest channel is 1). Needs the scene's meshes and instances.
void importLights(const aiScene& from, const NodePlaces& places, Scene& scene);

}  // namespace crevice
