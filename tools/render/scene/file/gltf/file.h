// SPDX-License-Identifier: MIT
// A glTF 2.0 file: its JSON, what tinygltf makes of it, the numbers of its accessors, and the parts
// that a scene is made of.
//
// Sources: Khronos Group, "glTF 2.0 Specification" (2021); EXT_meshopt_compression and
// KHR_draco_mesh_compression in Khronos' glTF repository.
#pragma once

#include "tools/render/scene/file/import.h"
#include "tools/render/scene/file/textures.h"

#include <nlohmann/json.hpp>

// tinygltf under a name of its own: Debian's libdraco.so exports another version of it, which would
// be taken or not by the order in which libraries are linked, and crash.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define tinygltf crevice_tinygltf
#include <tiny_gltf.h>
#undef tinygltf

#include <array>
#include <stdexcept>

namespace tinygltf = crevice_tinygltf;

namespace crevice {

using nlohmann::json;

/// A file that says what cannot be; load.cpp makes CV7002 of it.
struct BrokenGltf : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The member of that name; null where there is none, or nothing has members.
const json& member(const json& object, const std::string& name);

/// Below "extensions".
const json& extensionOf(const json& object, const std::string& name);

/// The entry of a list; null where there is none.
const json& entryOf(const json& list, const json& index);
const json& entryOf(const json& list, int index);

/// The data URI with the type that tinygltf knows. Throws BrokenGltf.
std::string octets(const std::string& data_uri);

/// The finite number, or `otherwise`.
double numberOf(const json& value, double otherwise);

/// The whole number from 0 on, or -1.
int indexOf(const json& value);

class GltfFile {
public:
    /// Its JSON alone. Throws BrokenGltf. Errors: CV7002.
    static Result<GltfFile> parse(const std::string& path);

    /// Has tinygltf read it and its buffers, unless it would unfold to more than its size allows.
    /// Throws BrokenGltf. Errors: CV7002.
    Status load(const std::string& path, SceneFolder& folder);

    const json& document() const { return document_; }
    const json& list(const char* name) const { return member(document_, name); }
    const tinygltf::Model& model() const { return model_; }

    /// Values of an accessor, `components` for each element: those of integers that are normalised
    /// from -1 or 0 to 1, sparse ones in their place. Components that it does not have are 0, or 1
    /// for the fourth. Throws BrokenGltf.
    std::vector<float> numbers(int accessor, int components) const;

    /// Of an accessor of whole numbers. Throws BrokenGltf.
    std::vector<std::uint32_t> indices(int accessor) const;

    /// Elements of an accessor; 0 where there is none of that index.
    std::size_t count(int accessor) const;

    const tinygltf::Accessor& accessor(int index) const;

    /// Of a buffer view, unfolded where meshopt compressed it. Throws BrokenGltf.
    std::string_view view(int index) const;

private:
    template <class Use>
    void eachElement(int accessor, const Use& use) const;
    std::string unfoldedView(int index, const json& packed) const;

    json document_ = {};
    std::string binary_ = {};  // the chunk of that name, until it is loaded
    tinygltf::Model model_ = {};
    mutable std::map<int, std::string> unfolded_ = {};  // by buffer view
};

/// What the largest value of a component of that type counts as 1 when it is normalised.
double largestOf(int component_type);

// --- keys.cpp: every key of its schema, every extension that is known ---

/// By the keys and extensions that `gltf` has.
LeftOut leftOutOf(const json& gltf);

/// Throws BrokenGltf for another version than 2.x. Errors: CV7002 for extensions that the file
/// requires and crevice does not read.
Status checkRequired(const json& gltf, const std::string& path);

// --- materials.cpp ---

/// Where a texture's coordinates come from.
struct Coordinates {
    int set = 0;  ///< TEXCOORD_set.
    glm::dvec2 offset = {0, 0}, scale = {1, 1};
    double angle_rad = 0;

    bool operator==(const Coordinates& other) const;
    glm::dvec2 operator()(const glm::dvec2& uv) const;
};

/// Materials, each as often as its textures have to be laid out in another way: what is drawn has
/// one set of texture coordinates, repeats all textures, and knows no colours of vertices.
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

// --- meshes.cpp ---

/// How a mesh is bent where it is drawn.
struct Bending {
    std::vector<double> weights = {};     ///< Of its morph targets.
    std::vector<glm::dmat4> joints = {};  ///< World from model; the mesh is in the world then.
};

struct GltfMesh {
    MeshDesc mesh;
    int material = 0;         ///< Into the scene's.
    std::size_t dropped = 0;  ///< Triangles with vertices that are missing or not finite.
    std::size_t turned = 0;   ///< See finishMesh.
};

/// Nothing for points and lines. Throws BrokenGltf.
std::optional<GltfMesh> gltfMesh(const GltfFile& file, int mesh, int primitive,
                                 const Bending& bending, GltfMaterials& materials);

// --- pose.cpp ---

struct PosedNode {
    glm::dmat4 parent_from_node = glm::dmat4(1.0);
    glm::dmat4 world_from_node = glm::dmat4(1.0);
    std::vector<double> weights = {};  ///< Of morph targets; empty for its mesh's.
    bool drawn = false;                ///< It is in the scene, and neither it nor a parent hidden.
};

/// Every node of the file, as the options say. Errors: CV8001 for an animation or a scene that the
/// file has not. Throws BrokenGltf.
Result<std::vector<PosedNode>> posedNodes(const GltfFile& file, const ImportOptions& options,
                                          LeftOut& left_out);

/// From the model to the world at each joint of a skin; empty for an index that is none.
/// Throws BrokenGltf.
std::vector<glm::dmat4> jointsOf(const GltfFile& file, int skin,
                                 const std::vector<PosedNode>& nodes);

}  // namespace crevice
