// SPDX-License-Identifier: MIT
// What `crevice render` does: a scene on a device, drawn through a config, and pictures of it.
#pragma once

#include "tools/commands/cli/config_options.h"
#include "tools/commands/cli/output.h"
#include "tools/render/camera_path.h"
#include "tools/render/device/open_device.h"
#include "tools/render/host_textures.h"
#include "tools/render/read_output.h"
#include "tools/render/scene/options.h"
#include "tools/render/scene_upload.h"

namespace crevice {

class Progress;

/// Frames along a path unless another number is asked for.
constexpr int kPathFrames = 32;

struct RenderOptions {
    ConfigOptions config;
    SceneOptions scene;
    HostPictureOptions pictures;  ///< Without files the scene is drawn.
    std::string backend;
    std::string precision;
    std::string program_cache;
    std::vector<std::string> textures;  ///< --texture: NAME=FILE, for imports of the config.
    std::vector<std::string> out = {"color=color.png"};
    std::vector<std::string> disable;
    std::string save_patch;
    std::string path;  ///< A camera path's name; every frame of it is written. Empty: none.
    int frames = 0;    ///< 0: one, or kPathFrames along a path.
    bool warm = false;
    bool watch = false;
    bool json = false;
    double read_ms = 0;  ///< What reading the config took, by the wall clock.
};

/// A picture that was asked for, and where its pixels come from.
struct Picture {
    NamedFile request;
    OutputSource source;
    Image image = {};
};

/// Everything about --out and --path that can be wrong, found before anything slow begins.
/// Errors: CV8001, CV7007.
Result<std::vector<Picture>> readRequests(const RenderOptions& options);

/// Has the description export every picture, and lists those exports. Errors: CV2209.
Result<std::vector<std::string>> exposeAll(std::vector<Picture>& pictures,
                                           Description& description);

/// Everything that draws. What comes later goes first.
struct Session {
    OpenDevice open;
    std::optional<UploadedScene> scene;
    std::optional<HostPictures> pictures;  ///< In place of the scene.
    std::optional<HostTextures> host;
    Frame frame;  ///< Of the scene; the config's has the host's textures.
    CompileOptions options;
    std::string lengths;  ///< As resolveLengths says.
    std::unique_ptr<Renderer> renderer;
    double plan_ms = 0;    ///< What `compile` took, by the wall clock,
    double create_ms = 0;  ///< ... Renderer::create, which plans too and compiles programs,
    double warm_ms = 0;    ///< ... and Renderer::warm, where that was asked for.
};

/// What glslang (tools/render/glsl/glsl_check.h) says of the shaders that a renderer of the
/// session would draw the description with, and then its driver. A plan that fails is no error.
Status checkShaders(Session& session, const Description& description,
                    const CompileOptions& options);

/// Puts the description's lengths into the units of what the session shows, and formats of imports
/// into those of its pictures; says what lengths they were. Errors: those of resolveLengths.
Result<std::string> fitToView(Session& session, Description& description);

/// Uploads the scene, whose view must outlive the session, or the pictures, and compiles the
/// description for it, whose outputs of these names are kept.
/// Errors: those of the context, the scene's objects, checkShaders and Renderer::create.
Result<Session> openSession(const RenderOptions& options, const SceneView& view,
                            std::optional<HostPictures> pictures, Description description,
                            const std::vector<std::string>& outputs, Progress& progress);

/// Draws the frames and reads every picture of the last one back. Gives the milliseconds of the
/// first, by the wall clock, the wait for the GPU included.
Result<double> draw(const RenderOptions& options, Session& session, std::vector<Picture>& pictures);

/// Draws the frames of the camera path of that name, which ends at the view's camera, and writes
/// every picture of each. Gives what `draw` gives. Errors: CV7007, and those of `draw`.
Result<double> drawPath(const RenderOptions& options, const SceneView& view, Session& session,
                        std::vector<Picture>& pictures);

/// Errors: CV7007.
Status writePictures(const std::vector<Picture>& pictures);

}  // namespace crevice
