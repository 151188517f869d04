// SPDX-License-Identifier: MIT
// What of glTF is read: every key of its schema, every extension that is known.
#pragma once

#include "tools/render/scene/file/gltf/file.h"
#include "tools/render/scene/file/left_out.h"

namespace crevice {

/// By the keys and extensions that `gltf` has.
LeftOut leftOutOf(const json& gltf);

/// Throws BrokenGltf for another version than 2.x. Errors: CV7002 for extensions that the file
/// requires and crevice does not read.
Status checkRequired(const json& gltf, const std::string& path);

}  // namespace crevice
