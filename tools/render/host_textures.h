// SPDX-License-Identifier: MIT
// The textures that a config imports, as its host would hand them over: those of a surface drawn,
// others read from pictures beside the config.
#pragma once

#include <crevice/renderer.h>

#include "core/gpu/owned.h"

namespace crevice {

/// Draws depth, normals, distances or positions of a scene, of which it knows `depth`, `normal`,
/// `linear_depth`, `log_depth` and `position`. Another texture, such as a tile of noise, is one of
/// the `files`, NAME=FILE, or NAME.png, .hdr or .exr in the folder of the file that declares the
/// import, or of the config. The device must outlive it.
class HostTextures {
public:
    /// For what the description imports of these and the frame does not have, each in the import's
    /// format where the device draws to that; where that is nothing, nothing is made. Errors: those
    /// of Renderer::create and Device::createTexture; CV7005 for a picture that is broken, CV8001
    /// for a file of no import, CV1204 for one that lies, after links, outside of the config's
    /// roots.
    static Result<HostTextures> make(Device& device, const Description& description, Extent extent,
                                     const Frame& scene,
                                     const std::vector<std::string>& files = {});

    /// The frame that such a host hands over: its cameras and lights, with the textures, drawn now,
    /// and the draws only where the description imports them. Holds until the next. Errors: those
    /// of Renderer::render.
    Result<Frame> frameOf(const Frame& scene);

    struct Picture {
        std::string name, file;
        Owned<TextureId> texture;
    };

    const std::vector<Picture>& pictures() const { return pictures_; }

private:
    Status readPicture(Device& device, const ImportDesc& import, const std::string& path);
    Status readBeside(Device& device, const ImportDesc& import, const SourceRef& source);
    Status readFiles(Device& device, const Description& description,
                     const std::vector<std::string>& files);

    std::vector<Picture> pictures_;
    std::unique_ptr<Renderer> renderer_;  // null where nothing is drawn
    std::vector<std::string> names_;
    bool draws_ = true;
};

/// A config's renderer with what a host hands it. The device must outlive it.
struct Drawn {
    std::optional<HostTextures> host;
    Frame frame;  ///< Of the host; its textures hold until the host's next one.
    std::unique_ptr<Renderer> renderer;

    /// Takes what a host hands over in the scene's frame, and makes the renderer; one that is there
    /// takes the extent alone. Errors: those of HostTextures, Renderer::create and
    /// Renderer::resize.
    Status prepare(Device& device, const Description& description, const Frame& scene,
                   const CompileOptions& options);

    /// Takes the host's frame for another of the scene, or again after its camera was moved.
    /// Requires `prepare`. Errors: those of Renderer::render.
    Status handOver(const Frame& scene);

    /// Lets go of all textures, and keeps the programs: many are known at once.
    void rest();
};

// --- host_pictures.cpp: a view that another engine drew: pictures of its depth and more, from
// files, and its projection ---

/// What the command line says of it.
struct HostPictureOptions {
    std::vector<std::string> files = {};  ///< --import: "depth=a.exr", "normal=n.png" ...
    std::string projection = {};          ///< --projection, or else a camera with near and far.
    bool zero_to_one = false;             ///< --zero-to-one: depth in clip space runs from 0.
};

class HostPictures {
public:
    /// Reads the files. `camera` is --camera's text. Errors: CV8001 for texts that say nothing of
    /// use, CV4005 for pictures of different sizes, those of readImage and of cameras.
    static Result<HostPictures> read(const HostPictureOptions& options, const std::string& camera);

    const Extent& extent() const { return pictures_.front().second.extent; }
    const Camera& camera() const { return camera_; }

    /// The module that reads such pictures, in place of the config's geometry.
    const char* module() const { return module_; }

    /// Median distance along the view axis of what is no background; nothing without any.
    std::optional<double> medianDistance() const;

    /// Sets the formats of the description's imports to those of the textures that `upload` makes.
    void fitFormats(Description& description) const;

    /// Gives the frame the camera, and the pictures as textures, which live as long as this.
    Status upload(Device& device, Frame& frame);

private:
    std::vector<std::pair<std::string, Image>> pictures_;
    std::vector<Owned<TextureId>> textures_;
    Camera camera_;
    const char* module_ = nullptr;
};

}  // namespace crevice
