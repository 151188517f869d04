// SPDX-License-Identifier: MIT
#include "tools/render/scene/options.h"

#include "core/base/text.h"
#include "tools/commands/cli/config_options.h"
#include "tools/render/scene/builtin_scenes.h"
#include "tools/render/scene/camera_framing.h"

#include <CLI/CLI.hpp>

#include <charconv>

namespace crevice {

void addImportOptions(CLI::App& app, ImportOptions& options)
{
    app.add_flag(
        "--any-format", options.any_format,
        "Read a scene in any format that Assimp supports; most of its readers are little tested");
    app.add_option("--import-time", options.time_s,
                   "Time limit for reading the scene, in seconds. Default: 3, plus 1 for each MiB "
                   "of the file")
        ->type_name("SECONDS")
        ->check([range = CLI::Range(1, 86400)](std::string text) {
            const bool bad = !range(text).empty();
            return bad ? "'" + text +
                             "' is no whole number of seconds from 1 to 86400, without a unit"
                       : "";
        });
    addRootOption(app, options.roots);
    app.add_option(
           "--time", options.pose_s,
           "Draw a glTF file's animation at that time. Default: nodes, skins and morph targets at "
           "rest")
        ->type_name("SECONDS");
    addText(app, "--animation", options.animation, "NAME|NUMBER",
            "The animation of --time; numbers count from 0. Default: the file's first one");
    addText(app, "--file-scene", options.file_scene, "NAME|NUMBER",
            "The scene of a glTF file that has several. Default: the one that the file names");
    using Word = const std::string&;
    app.add_option_function<std::string>(
           "--up", [&options](Word axis) { options.up = axis == "z" ? Up::z : Up::y; },
           "The axis of a file that points up. Default: z for STL, y for others")
        ->type_name("y|z")
        ->check(CLI::IsMember({"y", "z"}));
    app.add_option_function<std::string>(
           "--blended", [&options](Word way) { options.blended_solid = way == "solid"; },
           "Surfaces that are seen through (glass; glTF's BLEND): drawn over the lit picture, so "
           "that they take and cast no occlusion, or as others are. Default: over")
        ->type_name("over|solid")
        ->check(CLI::IsMember({"over", "solid"}));
}

void addSceneOption(CLI::App& app, std::string& scene)
{
    app.add_option("--scene", scene,
                   "A file (glTF 2.0, OBJ, FBX, PLY, STL, 3DS) or a built-in scene: " +
                       joined(builtinSceneNames()))
        ->type_name("FILE|NAME")
        ->capture_default_str();
}

void addCameraOption(CLI::App& app, std::string& camera)
{
    app.add_option(
           "--camera", camera,
           "The name of one of the scene's cameras; frame, which frames the scene, or "
           "frame=front|left|right|back|top|iso; or eye=X,Y,Z and, as wanted, ;at=X,Y,Z "
           ";up=X,Y,Z ;fov=DEGREES or ;ortho=HEIGHT ;shift=X,Y (off-centre, in pictures) "
           ";near=D ;far=D. Default: the scene's first camera that may see a mesh, else frame")
        ->type_name("CAMERA");
}

void addSceneOptions(CLI::App& app, SceneOptions& options)
{
    addSceneOption(app, options.scene);
    app.add_option("--size", options.size, "Pixels of the picture")
        ->type_name("WxH")
        ->capture_default_str();
    addCameraOption(app, options.camera);
    addImportOptions(app, options.import);
}

Result<Extent> parseSize(const std::string& text)
{
    Extent extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.width);
    const bool separated = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
    const auto height =
        separated ? std::from_chars(width.ptr + 1, end, extent.height) : std::from_chars_result{};
    const bool whole = separated && height.ec == std::errc() && height.ptr == end;
    if (whole && extent.width > 0 && extent.height > 0) return extent;
    return Diagnostic{Code::bad_size,
                      whole ? "the size '" + text + "' is not positive in both directions"
                            : "the size '" + text + "' is not two whole numbers, WIDTHxHEIGHT",
                      "write two numbers above 0 with a small x between: --size 960x540"};
}

Result<SceneView> loadSceneView(const SceneOptions& options)
{
    const Result<Extent> extent = parseSize(options.size);
    if (!extent) return extent.diagnostics();
    Result<Scene> scene = loadScene(options.scene, options.import);
    if (!scene) return scene.diagnostics();
    const Bounds bounds = scene->bounds();
    const double aspect = static_cast<double>(extent->width) / extent->height;
    const Result<SceneCamera> camera = chooseCamera(*scene, bounds, options.camera, aspect);
    if (!camera) return camera.diagnostics();
    return {SceneView{std::move(*scene), bounds, *camera, *extent}, scene.diagnostics()};
}

}  // namespace crevice
