// SPDX-License-Identifier: MIT
// What a host supplies.
#pragma once

#include "core/base/named.h"

namespace crevice {

enum class ImportType { camera, draw_list, lights, texture };

/// What the host supplies. A camera, draw list and lights give the uniforms listed in
/// core/frame/frame.h; a texture is a sampler of the import's name.
struct ImportDesc : Named {
    ImportType type = ImportType::texture;
    bool optional = false;  ///< Absent is allowed: 0 for a texture, no lights, nothing drawn.
    std::string format = "depth24";  ///< Of a texture: how finely it tells values apart.
};

}  // namespace crevice
