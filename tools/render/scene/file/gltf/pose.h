// SPDX-License-Identifier: MIT
// Where the nodes of a glTF file stand: at rest, or at a moment of its animation.
#pragma once

#include "tools/render/scene/file/gltf/keys.h"

#include <optional>

namespace crevice {

struct ImportOptions;

struct PosedNode {
    glm::dmat4 parent_from_node = glm::dmat4(1.0);
    glm::dmat4 world_from_node = glm::dmat4(1.0);
    std::vector<double> weights = {};  ///< Of morph targets; empty for its mesh's.
    bool drawn = false;                ///< It is in the scene, and neither it nor a parent hidden.
};

/// Every node of the file, as the options say. Errors: CV8001 for an animation or a scene that the
/// file has not. Throws BrokenGltf.
Result<std::vector<PosedNode>> posedNodes(const GltfFile& file, const ImportOptions& options,
                                          LeftOut& left_out);

/// From the model to the world at each joint of a skin; empty for an index that is none.
/// Throws BrokenGltf.
std::vector<glm::dmat4> jointsOf(const GltfFile& file, int skin,
                                 const std::vector<PosedNode>& nodes);

}  // namespace crevice
