// SPDX-License-Identifier: MIT
// Which scene is seen, from where and how large: the arguments that render, explain and reference
// share.
#pragma once

#include "tools/render/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace CLI {
class App;
}

namespace crevice {

struct SceneOptions {
    std::string scene = "room";    ///< --scene: a built-in name or a file.
    std::string size = "960x540";  ///< --size
    std::string camera;            ///< --camera, as tools/render/scene/camera_framing.h reads it.
    ImportOptions import = {};     ///< --any-format, --import-time, --root
};

/// What reading a scene's file may do.
void addImportOptions(CLI::App& app, ImportOptions& options);

void addSceneOption(CLI::App& app, std::string& scene);      ///< --scene
void addCameraOption(CLI::App& app, std::string& camera);    ///< --camera
void addSceneOptions(CLI::App& app, SceneOptions& options);  ///< Both, --size and the import's.

/// Reads "960x540". Errors: CV4005 for anything but two whole numbers of at least 1.
Result<Extent> parseSize(const std::string& text);

/// A scene and the view of it.
struct SceneView {
    Scene scene;
    Bounds bounds;
    SceneCamera camera;
    Extent extent;
};

/// Errors: those of parseSize, loadScene and chooseCamera; a scene's warnings come with the view.
Result<SceneView> loadSceneView(const SceneOptions& options);

/// Reads and tells a scene, as `crevice inspect` prints it; "left_out" are the warnings. Triangles,
/// vertices and surfaces count at each place of their mesh. Connected surfaces are closed, sheets
/// (closed without thickness) or open (sheetsOf). "unit" is what makes the diagonal that of a room
/// or a house, 5 to 50 m, if metres, centimetres or millimetres do, else "unknown". Errors: those
/// of loadScene.
Result<nlohmann::ordered_json> inspectScene(const std::string& scene, const ImportOptions& options);

}  // namespace crevice
