// SPDX-License-Identifier: MIT
// Primitives of glTF as meshes.
#pragma once

#include "tools/render/scene/file/gltf/materials.h"

namespace crevice {

/// How a mesh is bent where it is drawn.
struct Bending {
    std::vector<double> weights = {};     ///< Of its morph targets.
    std::vector<glm::dmat4> joints = {};  ///< World from model; the mesh is in the world then.
};

struct GltfMesh {
    MeshDesc mesh;
    int material = 0;         ///< Into the scene's.
    std::size_t dropped = 0;  ///< Triangles with vertices that are missing or not finite.
    std::size_t turned = 0;   ///< See finishMesh.
};

/// Nothing for points and lines. Throws BrokenGltf.
std::optional<GltfMesh> gltfMesh(const GltfFile& file, int mesh, int primitive,
                                 const Bending& bending, GltfMaterials& materials);

}  // namespace crevice
