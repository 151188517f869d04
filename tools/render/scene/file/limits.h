// SPDX-License-Identifier: MIT
// What a scene may take, by the size of its files: a small file that unfolds to a large scene is
// refused before it does.
#pragma once

#include "tools/commands/cli/child_process.h"
#include "tools/render/scene/scene.h"

namespace crevice {

/// At most. All grow with the size of the scene's files.
struct SceneLimits {
    double nodes;      ///< And meshes at them, as often as they are drawn.
    double parts;      ///< Primitives, and lights.
    double triangles;  ///< Of all primitives.
    double drawn;      ///< Triangles of all instances.
    double texels;     ///< Of all textures.
};

/// Of a scene whose files have so many bytes.
SceneLimits sceneLimits(std::uint64_t bytes);

/// Of the process that reads it, so far as the files are known.
ChildLimits readerLimits(std::uint64_t bytes, const ImportOptions& options);

/// CV7002: the scene has `count` of `what`, or says so.
Diagnostic overLimit(const std::string& path, const std::string& what, double count, double limit,
                     std::uint64_t bytes);

}  // namespace crevice
