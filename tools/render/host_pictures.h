// SPDX-License-Identifier: MIT
// A view that another engine drew: pictures of its depth and more, from files, and its projection.
#pragma once

#include <crevice/frame.h>

#include "core/gpu/owned.h"

namespace crevice {

class Device;
struct Description;

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
