// SPDX-License-Identifier: MIT
// Textures of a scene that is read: each image once, whichever materials use it.
#pragma once

#include "tools/render/scene/scene.h"

#include <functional>

namespace crevice {

class SceneFolder;

enum class Encoding { srgb, linear };

class SceneTextures {
public:
    static constexpr int kNone = -1;

    /// `path` is the scene file's: textures are looked for beside it. All must outlive it.
    SceneTextures(const std::string& path, SceneFolder& folder, Scene& scene, Diagnostics& warnings)
        : path_(path),
          folder_(folder),
          scene_(scene),
          warnings_(warnings)
    {
    }

    /// Index of the texture in the file of that name, or of one with the name's last part beside
    /// the scene. kNone for one that is missing or broken, with a warning CV7005, and for one that
    /// the folder does not open, without.
    int inFile(const std::string& name, Encoding encoding);

    /// The same of a file's bytes within the scene.
    int inBytes(const std::string& name, std::string_view bytes, Encoding encoding);

    /// The same of pixels.
    int inImage(const std::string& name, const Image& image, Encoding encoding);

    /// Another one, linear, of four channels; kNone where the scene has no room for so many texels.
    int add(const std::string& name, Image image);

    /// Texels that may still come.
    double room() const;

private:
    using Read = std::function<std::optional<Result<Image>>()>;
    int find(const std::string& name, Encoding encoding, const Read& read);
    int leaveOut(Diagnostic warning);

    const std::string& path_;
    SceneFolder& folder_;
    Scene& scene_;
    Diagnostics& warnings_;
    std::map<std::pair<std::string, Encoding>, int> indices_ = {};
    double texels_ = 0;  // of what was read
};

}  // namespace crevice
