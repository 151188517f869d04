// SPDX-License-Identifier: MIT
// Cameras and lights of an Assimp scene.
#pragma once

#include "tools/render/scene/scene.h"

#include <map>

struct aiScene;

namespace crevice {

/// world_from_node by node name: Assimp's cameras and lights stand where the node of their name is.
using NodePlaces = std::map<std::string, glm::dmat4>;

/// By the file's extension.
bool isGltf(const std::string& path);

/// Appends all cameras. `path` is the scene file's; its extension says whether it is glTF.
void importCameras(const aiScene& from, const std::string& path, const NodePlaces& places,
                   Scene& scene);

/// Appends point, spot and directional lights. Files give candela, lux, watts or plain fractions;
/// here a colour is what arrives at the centre of the scene, relative to what the brightest light
/// brings there (whose largest channel is 1). Needs the scene's meshes and instances.
void importLights(const aiScene& from, const NodePlaces& places, Scene& scene);

}  // namespace crevice
