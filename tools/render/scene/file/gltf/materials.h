// SPDX-License-Identifier: MIT
// Materials of glTF, each as often as its textures have to be laid out in another way: what is
// drawn has one set of texture coordinates, repeats all textures, and knows no colours of vertices.
#pragma once

#include "tools/render/scene/file/gltf/keys.h"
#include "tools/render/scene/file/textures.h"

#include <array>

namespace crevice {

/// Where a texture's coordinates come from.
struct Coordinates {
    int set = 0;  ///< TEXCOORD_set.
    glm::dvec2 offset = {0, 0}, scale = {1, 1};
    double angle_rad = 0;

    bool operator==(const Coordinates& other) const;
    glm::dvec2 operator()(const glm::dvec2& uv) const;
};

class GltfMaterials {
public:
    GltfMaterials(const GltfFile& file, SceneTextures& textures, Scene& scene, LeftOut& left_out);

    /// Of the first texture that the material has; nothing where it has none.
    std::optional<Coordinates> coordinates(int material) const;

    /// The scene's material for a mesh of glTF's `material` (-1 for the default one). Changes the
    /// mesh's texture coordinates, and gives its triangles corners of their own where `colors`,
    /// four numbers for each vertex or none, become a texture.
    int materialFor(int material, std::vector<float> colors, MeshDesc& mesh);

private:
    struct Tiles {  // of a texture along an axis: `count` from the one at `first` on
        int mode = 0, first = 0, count = 1;
        int texels = 1;  // for each of the texture's
    };
    using Layout = std::array<Tiles, 2>;

    SceneMaterial read(int material);
    int texture(const json& use, Encoding encoding);
    int image(const json& texture, Encoding encoding);
    Layout layoutFor(int material, const MeshDesc& mesh);
    static Extent extentOf(const Extent& size, const Layout& layout);
    bool fits(int texture, const Layout& layout) const;
    int laidOut(int texture, const Layout& layout);
    bool paint(const std::vector<float>& colors, SceneMaterial& material, MeshDesc& mesh);
    void setAlpha(int material, SceneMaterial& to) const;

    const GltfFile& file_;
    SceneTextures& textures_;
    Scene& scene_;
    LeftOut& left_out_;
    std::map<int, SceneMaterial> read_ = {};         // by glTF's index
    std::map<std::vector<float>, int> made_ = {};    // by all that makes two differ
    std::map<std::vector<int>, int> laid_out_ = {};  // by texture and layout
};

}  // namespace crevice
