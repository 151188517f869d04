// SPDX-License-Identifier: MIT
// What a glTF file says about itself and Assimp does not look at: its version and its extensions.
#pragma once

#include <crevice/diagnostic.h>

namespace crevice {

/// Reads the JSON of a .gltf or .glb file. One warning CV7010 lists what the file uses and is not
/// drawn. What is no glTF at all is left to the reader, which says more about it.
///
/// Errors: CV7002 for what would unfold to more than its size allows (limits.h), for another
/// version than 2.x, unless any will do, and for what would be drawn wrong: required extensions
/// that are not read, positions that are not floats.
Status checkGltf(const std::string& path, bool any_version);

}  // namespace crevice
