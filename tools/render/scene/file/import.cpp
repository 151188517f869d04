// SPDX-License-Identifier: MIT
// Scenes from files, by Assimp, whose texture coordinates begin at the lower left as ours do.
#include "tools/render/scene/file/import.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/gltf_check.h"
#include "tools/render/scene/file/limits.h"
#include "tools/render/scene/mesh_normals.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <exception>
#include <new>
#include <tuple>

namespace crevice {

namespace {

// Faces that meet at a sharper angle get an edge where a file has no normals: boxes stay boxes.
constexpr double kCreaseDegrees = 60.0;

// Coordinates beyond it overflow a float when squared.
constexpr float kMaxCoordinate = 1e18f;

// Normals and shared vertices are our own work: Assimp's takes minutes for a million triangles.
constexpr unsigned kPostProcess =
    aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent;

// Without the dot, as Assimp writes them. Its readers of other formats are older and less tried.
constexpr std::string_view kDefaultFormats[] = {"gltf", "glb", "obj", "ply", "stl", "3ds"};

// Files so large that their reader has no limit but the machine's.
constexpr std::uint64_t kAnySize = 1ull << 40;

// What Assimp says of a file may quote all of it.
constexpr std::size_t kLongestReason = 300;  // bytes

bool isDefaultExtension(std::string_view extension)
{
    return std::find(std::begin(kDefaultFormats), std::end(kDefaultFormats), extension) !=
           std::end(kDefaultFormats);
}

glm::dmat4 matrixFrom(const aiMatrix4x4& m)  // Assimp's has rows, ours columns
{
    return glm::transpose(glm::make_mat4(&m.a1));
}

bool usable(const aiVector3D& v)
{
    return std::abs(v.x) <= kMaxCoordinate && std::abs(v.y) <= kMaxCoordinate &&
           std::abs(v.z) <= kMaxCoordinate;  // false for NaN
}

bool usable(const aiMesh& mesh, const aiFace& face)
{
    return std::all_of(face.mIndices, face.mIndices + face.mNumIndices, [&](unsigned index) {
        return index < mesh.mNumVertices && usable(mesh.mVertices[index]);
    });
}

// Removes the faces that no later step could bear; returns how many. Assimp cuts polygons where a
// mesh says that it has some, and asserts that it does.
unsigned dropBrokenFaces(aiMesh& mesh)
{
    unsigned kept = 0;
    for (unsigned index = 0; index < mesh.mNumFaces; ++index) {
        if (!usable(mesh, mesh.mFaces[index])) continue;
        if (kept != index) std::swap(mesh.mFaces[kept], mesh.mFaces[index]);
        ++kept;
    }
    const unsigned dropped = mesh.mNumFaces - kept;
    mesh.mNumFaces = kept;
    mesh.mPrimitiveTypes =
        kept == 0 ? aiPrimitiveType_TRIANGLE : 0;  // Assimp refuses a mesh of none
    for (unsigned index = 0; index < kept; ++index)
        mesh.mPrimitiveTypes |= AI_PRIMITIVE_TYPE_FOR_N_INDICES(mesh.mFaces[index].mNumIndices);
    return dropped;
}

// Adding zero makes -0 to 0, so that equal vertices are equal in all their bits.
Vertex vertexFrom(const aiMesh& mesh, unsigned index)
{
    Vertex vertex;
    const aiVector3D& position = mesh.mVertices[index];
    const aiVector3D from = mesh.HasNormals() ? mesh.mNormals[index] : aiVector3D(0, 0, 0);
    const glm::dvec3 normal(from.x, from.y, from.z);
    const double length = glm::length(normal);
    const bool usable_normal = length > 0.0 && std::isfinite(length);
    for (int axis = 0; axis < 3; ++axis) {
        vertex.position[axis] = position[axis] + 0.0f;
        vertex.normal[axis] =
            usable_normal ? static_cast<float>(normal[axis] / length) + 0.0f : 0.0f;
    }
    if (mesh.HasTextureCoords(0) && usable(mesh.mTextureCoords[0][index])) {
        vertex.uv[0] = mesh.mTextureCoords[0][index].x + 0.0f;
        vertex.uv[1] = mesh.mTextureCoords[0][index].y + 0.0f;
    }
    return vertex;
}

MeshDesc meshFrom(const aiMesh& from, double crease_degrees, std::size_t& turned)
{
    MeshDesc mesh;
    mesh.label = from.mName.C_Str();
    mesh.vertices.reserve(from.mNumVertices);
    for (unsigned index = 0; index < from.mNumVertices; ++index)
        mesh.vertices.push_back(vertexFrom(from, index));
    mesh.indices.reserve(static_cast<std::size_t>(from.mNumFaces) * 3);
    for (unsigned index = 0; index < from.mNumFaces; ++index) {
        const aiFace& face = from.mFaces[index];
        if (face.mNumIndices == 3)
            mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
    }
    turned += finishMesh(mesh, from.HasNormals(), crease_degrees);
    return mesh;
}

bool finite(const glm::dmat4& matrix)
{
    const double* const begin = glm::value_ptr(matrix);
    return std::all_of(begin, begin + 16, [](double each) { return std::isfinite(each); });
}

// Flattens the hierarchy. A stack of its own: a file may nest deeper than the program's.
NodePlaces importNodes(const aiScene& from, Scene& scene)
{
    NodePlaces places;
    std::vector<std::pair<const aiNode*, glm::dmat4>> open = {{from.mRootNode, glm::dmat4(1.0)}};
    while (!open.empty()) {
        const auto [node, world_from_parent] = open.back();
        open.pop_back();
        const glm::dmat4 world_from_node = world_from_parent * matrixFrom(node->mTransformation);
        places.emplace(node->mName.C_Str(), world_from_node);
        for (unsigned k = 0; k < node->mNumMeshes; ++k) {
            const unsigned mesh = node->mMeshes[k];
            if (mesh >= from.mNumMeshes || !finite(world_from_node)) continue;
            const std::size_t material = from.mMeshes[mesh]->mMaterialIndex;
            scene.instances.push_back(
                {static_cast<int>(mesh), world_from_node,
                 static_cast<int>(std::min(material, scene.materials.size() - 1))});
        }
        for (unsigned k = node->mNumChildren; k > 0; --k)
            open.emplace_back(node->mChildren[k - 1], world_from_node);
    }
    return places;
}

Diagnostic noTriangle(const std::string& path, unsigned dropped)
{
    return {Code::scene_empty,
            "the scene '" + path + "' has no triangle with an area" +
                (dropped > 0 ? " and finite vertices" : ""),
            "points and lines cast no occlusion; export the scene with its faces"};
}

// Faces that enclose an area.
bool hasSurface(const aiScene& scene)
{
    for (unsigned mesh = 0; mesh < scene.mNumMeshes; ++mesh)
        for (unsigned face = 0; face < scene.mMeshes[mesh]->mNumFaces; ++face)
            if (scene.mMeshes[mesh]->mFaces[face].mNumIndices >= 3) return true;
    return false;
}

// Whether some triangle has an area where it is drawn: a scale of 0 takes it away.
bool hasArea(const Scene& scene)
{
    for (const SceneInstance& instance : scene.instances) {
        const MeshDesc& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto placed = [&](std::uint32_t index) {
            return instance.place(glm::make_vec3(mesh.vertices[index].position));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::dvec3 corner = placed(mesh.indices[i]);
            const glm::dvec3 normal = glm::cross(placed(mesh.indices[i + 1]) - corner,
                                                 placed(mesh.indices[i + 2]) - corner);
            if (normal != glm::dvec3(0)) return true;
        }
    }
    return false;
}

Diagnostic turnedWarning(const std::string& path, std::size_t triangles, std::size_t surfaces)
{
    std::vector<std::string> wrong;
    if (triangles > 0)
        wrong.push_back("normals that face away from " + std::to_string(triangles) +
                        " of its triangles");
    if (surfaces > 0)
        wrong.push_back(std::to_string(surfaces) + " of its closed surfaces inside out");
    return asWarning({Code::scene_features,
                      "the scene '" + path + "' has " + joined(wrong, " and "),
                      "they are turned; have normals recalculated where the file comes from"});
}

Scene sceneFrom(const aiScene& from, const std::string& path, SceneFolder& folder,
                Diagnostics& warnings)
{
    Scene scene;
    scene.name = std::filesystem::path(path).stem().string();
    importMaterials(from, path, folder, scene, warnings);
    const double crease = isGltf(path) ? kGltfCreaseDegrees : kCreaseDegrees;
    std::size_t faces = 0;
    for (unsigned index = 0; index < from.mNumMeshes; ++index)
        scene.meshes.push_back(meshFrom(*from.mMeshes[index], crease, faces));
    const NodePlaces places = importNodes(from, scene);
    importCameras(from, path, places, scene);
    const std::size_t surfaces = turnInsideOut(scene);
    if (faces + surfaces > 0) warnings.push_back(turnedWarning(path, faces, surfaces));
    importLights(from, places, scene);
    return scene;
}

// Assimp's scene may draw a mesh at many places, and have more than is in the files.
Status checkCounts(const aiScene& scene, const std::string& path, std::uint64_t bytes)
{
    const SceneLimits limits = sceneLimits(bytes);
    double triangles = 0, drawn = 0, nodes = 0;
    for (unsigned mesh = 0; mesh < scene.mNumMeshes; ++mesh)
        triangles += scene.mMeshes[mesh]->mNumFaces;
    std::vector<const aiNode*> open = {scene.mRootNode};
    while (!open.empty()) {
        const aiNode& node = *open.back();
        open.pop_back();
        nodes += 1 + node.mNumMeshes;
        for (unsigned k = 0; k < node.mNumMeshes; ++k)
            if (node.mMeshes[k] < scene.mNumMeshes)
                drawn += scene.mMeshes[node.mMeshes[k]]->mNumFaces;
        open.insert(open.end(), node.mChildren, node.mChildren + node.mNumChildren);
    }
    const std::tuple<const char*, double, double> counts[] = {
        {"nodes and meshes at them", nodes, limits.nodes},
        {"primitives", scene.mNumMeshes, limits.parts},
        {"lights", scene.mNumLights, limits.parts},
        {"triangles", triangles, limits.triangles},
        {"triangles at all nodes", drawn, limits.drawn}};
    for (const auto& [what, count, limit] : counts)
        if (count > limit) return overLimit(path, what, count, limit, bytes);
    return {};
}

// Opens what the scene's folder allows, and nothing for writing. The reader may take more for each
// file.
class SceneFiles : public Assimp::DefaultIOSystem {
public:
    SceneFiles(SceneFolder& folder, const ImportOptions& options)
        : folder_(folder),
          options_(options)
    {
    }

    bool Exists(const char* file) const override { return folder_.allows(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        const bool reads = std::string_view(mode).find_first_of("wa+") == std::string_view::npos;
        const bool opens = reads && !folder_.refuses(file) && folder_.allows(file);
        if (!opens) return nullptr;
        folder_.opens(file);
        limitSelf(readerLimits(folder_.bytes(), options_));
        return DefaultIOSystem::Open(file, mode);
    }

private:
    SceneFolder& folder_;
    const ImportOptions& options_;
};

// A file is otherwise read by whichever reader knows its first bytes, whatever its name.
void keepDefaultFormats(Assimp::Importer& importer)
{
    for (std::size_t index = importer.GetImporterCount(); index-- > 0;) {
        const std::string extensions = importer.GetImporterInfo(index)->mFileExtensions;
        if (!isDefaultExtension(extensions.substr(0, extensions.find(' '))))
            importer.UnregisterLoader(importer.GetImporter(index));
    }
}

void configure(Assimp::Importer& importer, const ImportOptions& options, SceneFolder& folder)
{
    if (!options.any_format) keepDefaultFormats(importer);
    importer.SetIOHandler(new SceneFiles(folder, options));  // which it deletes
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_COLORS | aiComponent_TANGENTS_AND_BITANGENTS |
                                    aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS);
}

// Why there is no scene; throws where that is for want of memory.
Diagnostic failureOf(const Assimp::Importer& importer, const std::string& path,
                     const SceneFolder& folder)
{
    try {
        if (importer.GetException()) std::rethrow_exception(importer.GetException());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {  // its text is the importer's
    }
    Diagnostic error = brokenScene(path, importer.GetErrorString());
    if (folder.refusedAny()) {
        error.notes.push_back({{}, folder.warning().message});
        error.help = folder.warning().help;
    }
    return error;
}

Result<Scene> readByAssimp(const std::string& path, const ImportOptions& options,
                           Diagnostics warnings)
{
    SceneFolder folder(path, options.roots);
    Assimp::Importer importer;
    configure(importer, options, folder);
    if (!importer.ReadFile(path, 0)) return failureOf(importer, path, folder);

    // Before Assimp cuts polygons, since it compares coordinates.
    unsigned dropped = 0;
    const aiScene* const read = importer.GetScene();
    for (unsigned index = 0; index < read->mNumMeshes; ++index)
        dropped += dropBrokenFaces(*read->mMeshes[index]);
    if (!hasSurface(*read)) return noTriangle(path, dropped);
    const aiScene* const scene = importer.ApplyPostProcessing(kPostProcess);
    if (!scene) return failureOf(importer, path, folder);
    const Status fits = checkCounts(*scene, path, folder.bytes());
    if (!fits) return fits.diagnostics();
    limitSelf(readerLimits(kAnySize, options));  // what follows is our own, and bounded

    if (dropped > 0)
        warnings.push_back(asWarning({Code::not_finite,
                                      "the scene '" + path + "' has " + std::to_string(dropped) +
                                          " faces with vertices that are not finite",
                                      "they are left out"}));
    Scene result = sceneFrom(*scene, path, folder, warnings);
    if (folder.refusedAny()) warnings.push_back(folder.warning());
    if (!hasArea(result)) return noTriangle(path, dropped);
    return {std::move(result), std::move(warnings)};
}

// A PLY file that was cut off before the end of its header, for which Assimp looks for ever, or
// that counts more elements than it has bytes, for which Assimp takes memory at once.
Status checkPly(const std::string& path)
{
    constexpr std::size_t kLongestHeader =
        1 << 20;  // a line an element or property takes some thirty bytes
    const std::string start = readStart(path, kLongestHeader).bytes;
    if (!startsWith(start, "ply")) return {};
    if (!has(start, "end_header")) return brokenScene(path, "it ends within its header");
    std::error_code error;
    const std::uint64_t bytes = std::filesystem::file_size(path, error);
    constexpr std::string_view kBlank = " \t", kElement = "element";
    for (std::size_t at = 0; (at = start.find(kElement, at)) != start.npos;) {
        const bool begins_line = start[at - 1] == '\n' || start[at - 1] == '\r';
        at += kElement.size();
        const std::size_t name = start.find_first_not_of(kBlank, at);
        std::string_view count = start;
        count.remove_prefix(std::min(start.find_first_of(kBlank, name), start.size()));
        const double claimed = takeNumber(count).value_or(0.0);
        if (begins_line && claimed > static_cast<double>(bytes))
            return overLimit(path, "elements of one kind", claimed, static_cast<double>(bytes),
                             bytes);
    }
    return {};
}

}  // namespace

bool isDefaultFormat(const std::string& path)
{
    const std::string extension = lowerExtension(path);
    return !extension.empty() && isDefaultExtension(std::string_view(extension).substr(1));
}

Diagnostic brokenScene(const std::string& path, const std::string& reason, std::string help)
{
    Diagnostic error = {Code::scene_broken,
                        "the scene '" + path +
                            "' cannot be read: " + std::string(utf8Prefix(reason, kLongestReason)),
                        std::move(help)};
    while (!error.message.empty() && (error.message.back() == '.' || error.message.back() == '\n'))
        error.message.pop_back();
    return error;
}

Result<Scene> readScene(const std::string& path, const ImportOptions& options)
{
    if (const Status ply = checkPly(path); !ply) return ply.diagnostics();
    if (!isGltf(path)) return readByAssimp(path, options, {});
    const Status checked = checkGltf(path, options.any_format);
    if (!checked) return checked.diagnostics();
    return readByAssimp(path, options, checked.diagnostics());
}

}  // namespace crevice
