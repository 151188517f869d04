// SPDX-License-Identifier: MIT
// Scenes from files but glTF, by Assimp, whose texture coordinates begin at the lower left as ours
// do.
#include "core/base/files.h"
#include "core/base/text.h"
#include "core/frame/frame_math.h"
#include "tools/render/image/image_file.h"
#include "tools/render/image/srgb.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/import.h"
#include "tools/render/scene/file/textures.h"
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

// Normals and shared vertices are our own work: Assimp's takes minutes for a million triangles.
constexpr unsigned kPostProcess =
    aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent;

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

Vertex vertexFrom(const aiMesh& mesh, unsigned index)
{
    Vertex vertex;
    setVertex(vertex, &mesh.mVertices[index].x,
              mesh.HasNormals() ? &mesh.mNormals[index].x : nullptr);
    if (mesh.HasTextureCoords(0) && usable(mesh.mTextureCoords[0][index])) {
        vertex.uv[0] = mesh.mTextureCoords[0][index].x + 0.0f;
        vertex.uv[1] = mesh.mTextureCoords[0][index].y + 0.0f;
    }
    return vertex;
}

MeshDesc meshFrom(const aiMesh& from)
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
    return mesh;
}

// The mesh's material, or one of its own where its vertices have colours, which become a texture.
int materialOf(const aiMesh& from, bool with_colors, SceneTextures& textures, LeftOut& left_out,
               Scene& scene, MeshDesc& mesh)
{
    const std::size_t index =
        std::min(std::size_t{from.mMaterialIndex}, scene.materials.size() - 1);
    if (!with_colors || !from.HasVertexColors(0)) return static_cast<int>(index);
    std::vector<float> colors;
    for (unsigned k = 0; k < from.mNumVertices; ++k) {
        const aiColor4D& color = from.mColors[0][k];
        for (const float each : {color.r, color.g, color.b}) colors.push_back(linearFromSrgb(each));
        colors.push_back(color.a);
    }
    SceneMaterial material = scene.materials[index];
    Image image;
    if (material.base_color_texture < 0) image = paintedCorners(colors, textures.room(), mesh);
    if (image.pixels.empty()) {
        left_out.shape.insert("colours of vertices on textured surfaces");
        return static_cast<int>(index);
    }
    material.base_color = glm::vec4(1.0f);
    material.base_color_texture = textures.add(mesh.label + " colours", std::move(image));
    scene.materials.push_back(std::move(material));
    return static_cast<int>(scene.materials.size()) - 1;
}

// Flattens the hierarchy. A stack of its own: a file may nest deeper than the program's.
NodePlaces importNodes(const aiScene& from, const std::vector<int>& materials, Scene& scene)
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
            if (mesh >= from.mNumMeshes || !isFinite(world_from_node)) continue;
            scene.instances.push_back({static_cast<int>(mesh), world_from_node, materials[mesh]});
        }
        for (unsigned k = node->mNumChildren; k > 0; --k)
            open.emplace_back(node->mChildren[k - 1], world_from_node);
    }
    return places;
}

// What surfaces have no place for.
void findLeftOut(const aiScene& from, LeftOut& left_out)
{
    for (unsigned index = 0; index < from.mNumMeshes; ++index) {
        const aiMesh& mesh = *from.mMeshes[index];
        if (mesh.HasBones()) left_out.shape.insert("the pose of its skeleton");
        if (mesh.mNumAnimMeshes > 0) left_out.shape.insert("morph targets");
        for (unsigned face = 0; face < mesh.mNumFaces; ++face)
            if (mesh.mFaces[face].mNumIndices < 3) left_out.shape.insert("points and lines");
    }
    if (from.HasAnimations()) left_out.shape.insert("its animation");
}

// Faces that enclose an area.
bool hasSurface(const aiScene& scene)
{
    for (unsigned mesh = 0; mesh < scene.mNumMeshes; ++mesh)
        for (unsigned face = 0; face < scene.mMeshes[mesh]->mNumFaces; ++face)
            if (scene.mMeshes[mesh]->mFaces[face].mNumIndices >= 3) return true;
    return false;
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
    explicit SceneFiles(SceneFolder& folder) : folder_(folder) {}

    bool Exists(const char* file) const override { return folder_.allows(file); }
    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        const bool reads = std::string_view(mode).find_first_of("wa+") == std::string_view::npos;
        const bool refused = reads && folder_.refuses(file);
        const bool opens = reads && !refused && folder_.allows(file);
        if (!opens && !refused && lowerExtension(file) == ".mtl") folder_.lacks(file);
        if (!opens) return nullptr;
        folder_.opens(file);
        return DefaultIOSystem::Open(file, mode);
    }

private:
    SceneFolder& folder_;
};

// A file is otherwise read by whichever reader knows its first bytes, whatever its name.
void keepDefaultFormats(Assimp::Importer& importer)
{
    for (std::size_t index = importer.GetImporterCount(); index-- > 0;) {
        const std::string extensions = importer.GetImporterInfo(index)->mFileExtensions;
        if (!contains(kDefaultFormats,
                      std::string_view(extensions).substr(0, extensions.find(' '))))
            importer.UnregisterLoader(importer.GetImporter(index));
    }
}

void configure(Assimp::Importer& importer, const ImportOptions& options, SceneFolder& folder)
{
    if (!options.any_format) keepDefaultFormats(importer);
    importer.SetIOHandler(new SceneFiles(folder));  // which it deletes
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
                                aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_ANIMATIONS);
}

// Why there is no scene; throws where that is for want of memory.
Diagnostic failureOf(const Assimp::Importer& importer, const std::string& path)
{
    try {
        if (importer.GetException()) std::rethrow_exception(importer.GetException());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {  // its text is the importer's
    }
    return brokenScene(path, importer.GetErrorString());
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
    if (has(start, "element tristrips"))
        return brokenScene(path, "strips of triangles are not read",
                           "save it with faces, for example by MeshLab");
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
    if (!has(start, "element face"))
        return Diagnostic{Code::scene_empty, "the scene '" + path + "' has no faces",
                          "points and splats cast no occlusion; export the scene with its faces"};
    return {};
}

}  // namespace

Result<ReadScene> readByAssimp(const std::string& path, const ImportOptions& options,
                               SceneFolder& folder, Diagnostics& warnings)
{
    if (const Status ply = checkPly(path); !ply) return ply.diagnostics();
    Assimp::Importer importer;
    configure(importer, options, folder);
    if (!importer.ReadFile(path, 0)) return failureOf(importer, path);

    // Before Assimp cuts polygons, since it compares coordinates.
    ReadScene read;
    const aiScene* const whole = importer.GetScene();
    for (unsigned index = 0; index < whole->mNumMeshes; ++index)
        read.dropped += dropBrokenFaces(*whole->mMeshes[index]);
    LeftOut left_out;
    findLeftOut(*whole, left_out);
    if (options.pose_s) left_out.shape.insert("the moment of --time, which is read of glTF alone");
    if (!hasSurface(*whole)) return read;
    const aiScene* const from = importer.ApplyPostProcessing(kPostProcess);
    if (!from) return failureOf(importer, path);
    if (const Status fits = checkCounts(*from, path, folder.bytes()); !fits)
        return fits.diagnostics();

    Scene& scene = read.scene;
    SceneTextures textures(path, folder, scene, warnings);
    importMaterials(*from, textures, scene, left_out);
    for (const std::string& file : folder.opened()) findLeftOutOfMtl(file, left_out);
    if (const std::string& lacking = folder.lacking(); !lacking.empty() && !folder.refusedAny())
        left_out.shape.insert("its materials, since there is no file '" + lacking + "'");
    std::vector<int> materials;
    for (unsigned index = 0; index < from->mNumMeshes; ++index) {
        aiMesh& each = *from->mMeshes[index];
        MeshDesc mesh = meshFrom(each);
        delete[] std::exchange(each.mFaces, nullptr);  // as large as all else
        each.mNumFaces = 0;
        // Two programs mean opposite things by the bit that says which facets have colours.
        const bool facets = lowerExtension(path) == ".stl" && each.HasVertexColors(0);
        if (facets) left_out.look.insert("colours of facets");
        materials.push_back(materialOf(each, !facets, textures, left_out, scene, mesh));
        read.turned += finishMesh(mesh, each.HasNormals(), kCreaseDegrees);
        scene.meshes.push_back(std::move(mesh));
    }
    const NodePlaces places = importNodes(*from, materials, scene);
    importCameras(*from, places, scene);
    importLights(*from, places, scene);
    if (left_out.any()) warnings.push_back(left_out.warning(path));
    return read;
}

}  // namespace crevice
