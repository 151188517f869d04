// SPDX-License-Identifier: MIT
// Scenes that need no file: the default one, and simple ones whose occlusion is known.
//
// Lengths are in metres. Closed objects rest on the floor, sunk in by a hair, and no two faces that
// can be seen lie in one plane. Each scene has a camera "main", one point light and a weak
// directional one.
#pragma once

#include "tools/render/scene/scene.h"

namespace crevice {

/// "corner", "plane", "room", "spheres", "street".
const std::vector<std::string>& builtinSceneNames();

/// A line on each.
inline const std::map<std::string, std::string> kBuiltinScenes = {
    {"corner", "A floor and a wall, whose occlusion is known"},
    {"plane", "A floor alone, where nothing may occlude"},
    {"room", "Furniture and the Stanford bunny in a room; needs Debian's glmark2-data"},
    {"spheres", "Three spheres on a floor"},
    {"street", "Houses, rails and leaves: thin and open surfaces, near and far"}};

/// Whether a scene of that name is a file; "" is none.
bool isFileScene(const std::string& scene);

/// Whether a built-in scene has a mesh that is a file of the system's.
bool needsFile(std::string_view builtin_scene);

/// The scene of that name. "room" needs the Stanford bunny of Debian's glmark2-data, looked for as
/// bunny.obj in the folder that CREVICE_MODELS names, then as glmark2/models/bunny.obj in those of
/// XDG_DATA_DIRS, then in /usr/local/share and /usr/share.
///
/// Errors: CV7001 for another name or a missing bunny; those of a broken bunny.
Result<Scene> builtinScene(std::string_view name);

}  // namespace crevice
