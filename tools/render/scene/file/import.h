// SPDX-License-Identifier: MIT
// Scenes from files, in this process; what `importScene` runs in one of its own, and its parts.
#pragma once

#include "tools/commands/cli/child_process.h"
#include "tools/render/scene/scene.h"

#include <set>

struct aiScene;

namespace crevice {

class SceneFolder;
class SceneTextures;

/// What a message may suggest instead of a file that cannot be read.
constexpr const char* kSceneFormats =
    "scenes are glTF 2.0 (.gltf, .glb), OBJ, FBX, PLY, STL or 3DS";

/// Without the dot, as Assimp writes them. Its readers of other formats are older and less tried.
inline const std::vector<std::string> kDefaultFormats = {"gltf", "glb", "obj", "fbx",
                                                         "ply",  "stl", "3ds"};

/// Whether the file's extension is that of a format that is read unless any is asked for.
bool isDefaultFormat(const std::string& path);

/// By the file's extension.
bool isGltf(const std::string& path);

/// "Base Color.png" of "Base%20Color.png", as URIs write it.
std::string percentDecoded(const std::string& text);

/// Coordinates beyond it overflow a float when squared.
constexpr float kMaxCoordinate = 1e18f;

/// Sets place and normal, by three numbers each; a normal of no length, or null, becomes 0. -0
/// becomes 0, so that equal vertices are equal in all their bits.
void setVertex(Vertex& vertex, const float* position, const float* normal);

/// CV7002.
Diagnostic brokenScene(const std::string& path, const std::string& reason,
                       std::string help = kSceneFormats);

/// What a scene may take, at most, by the size of its files: a small file that unfolds to a large
/// scene is refused before it does.
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

/// A scene as a file has it, and what was wrong with it.
struct ReadScene {
    Scene scene = {};
    std::size_t dropped = 0;  ///< Faces that had no finite place.
    std::size_t turned = 0;   ///< See finishMesh.
};

/// Requires a regular file; may crash, hang or fill the memory. Errors: CV7002, CV7003.
Result<Scene> readScene(const std::string& path, const ImportOptions& options);

/// Throws BrokenGltf for what the reader or the accessors find.
Result<ReadScene> readGltf(const std::string& path, const ImportOptions& options,
                           SceneFolder& folder, Diagnostics& warnings);

/// Throws what Assimp throws.
Result<ReadScene> readByAssimp(const std::string& path, const ImportOptions& options,
                               SceneFolder& folder, Diagnostics& warnings);

/// What a scene's file has and crevice does not draw.
struct LeftOut {
    std::set<std::string> shape = {};  ///< Surfaces, or holes in them, are not as the file says.
    std::set<std::string> look = {};   ///< Their colours are not.

    bool any() const { return !shape.empty() || !look.empty(); }

    /// CV7010. Requires any().
    Diagnostic warning(const std::string& path) const;
};

/// Adds what a file of OBJ's materials says that is not read; other files have nothing of it.
void findLeftOutOfMtl(const std::string& file, LeftOut& left_out);

/// The keys of such a file, and those and the extensions of glTF, as tables in Markdown.
std::string mtlTable();
std::string gltfTables();

/// Appends a material for each of `from`'s, in its order, and the base-colour textures that they
/// use, each once.
void importMaterials(const aiScene& from, SceneTextures& textures, Scene& scene, LeftOut& left_out);

/// `colors` has four numbers for each vertex. Gives each triangle corners of its own, whose texture
/// coordinates are those of the texture that is returned: a block of 2 x 2 texels for each, between
/// whose middles its colours run straight. Empty, and nothing changed, where there would be more
/// than `most_texels`.
Image paintedCorners(const std::vector<float>& colors, double most_texels, MeshDesc& mesh);

/// Textures with alpha of which fewer texels than this part are neither clear nor solid are cut
/// out.
constexpr double kMostVague = 0.1;
constexpr float kClear = 0.1f, kSolid = 0.9f;

/// The part of the texels that are neither clear nor solid, and the least alpha of all.
std::pair<double, float> alphaOf(const Image& image);

/// world_from_node by node name: Assimp's cameras and lights stand where the node of their name is.
using NodePlaces = std::map<std::string, glm::dmat4>;

/// view_from_world; both directions have length 1, and any `up` will do where it is along the view.
glm::dmat4 viewAlong(const glm::dvec3& eye, const glm::dvec3& forward, glm::dvec3 up);

/// Appends all cameras.
void importCameras(const aiScene& from, const NodePlaces& places, Scene& scene);

/// Appends point, spot and directional lights.
void importLights(const aiScene& from, const NodePlaces& places, Scene& scene);

/// Turns closed surfaces that are inside out, winding and normals, and returns how many. A room
/// that is seen from inside is no such surface: a camera, or the centre of another surface's box,
/// is in its box.
std::size_t turnInsideOut(Scene& scene);

/// Files give candela, lux, watts or plain fractions; afterwards a light's colour is what arrives
/// at the centre of the scene, relative to what the brightest light brings there (whose largest
/// channel is 1): an exposure for the scene's middle.
void normalizeLights(Scene& scene);

}  // namespace crevice
