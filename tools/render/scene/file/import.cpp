// SPDX-License-Identifier: MIT
// What all files have in common once their reader is done.
#include "tools/render/scene/file/import.h"

#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/image/image_file.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/gltf/file.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

// Files so large that their reader has no limit but the machine's.
constexpr std::uint64_t kAnySize = 1ull << 40;

// What a reader says of a file may quote all of it.
constexpr std::size_t kLongestReason = 300;  // bytes

Diagnostic noTriangle(const std::string& path, std::size_t dropped)
{
    return {Code::scene_empty,
            "the scene '" + path + "' has no triangle with an area" +
                (dropped > 0 ? " and finite vertices" : ""),
            "points and lines cast no occlusion; export the scene with its faces"};
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

// From z up to y up.
void standUp(Scene& scene)
{
    const glm::dmat4 up = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};
    for (SceneInstance& each : scene.instances) each.world_from_model = up * each.world_from_model;
    for (SceneCamera& each : scene.cameras) each.view_from_world *= glm::transpose(up);
    for (SceneLight& each : scene.lights) {
        each.light.position = glm::dmat3(up) * glm::dvec3(each.light.position);
        each.light.direction = glm::dmat3(up) * glm::dvec3(each.light.direction);
    }
}

// Sets what is seen through apart, unless there is nothing else, of which it warns.
Diagnostics setBlendedApart(Scene& scene, const std::string& path)
{
    const auto solid = [&](const SceneInstance& each) {
        return !scene.materials[static_cast<std::size_t>(each.material)].blended;
    };
    std::vector<SceneInstance>& all = scene.instances;
    const auto first = std::stable_partition(all.begin(), all.end(), solid);
    if (first == all.begin())
        return {asWarning({Code::scene_features,
                           "the scene '" + path +
                               "' is seen through at all of its meshes (BLEND, "
                               "transmission, d), which are drawn solid",
                           "make what is solid so in the file"})};
    scene.blended.assign(first, all.end());
    all.erase(first, all.end());
    return {};
}

Result<Scene> finished(ReadScene read, const std::string& path, const ImportOptions& options,
                       Diagnostics warnings)
{
    Scene& scene = read.scene;
    scene.name = std::filesystem::path(path).stem().string();
    if (!hasArea(scene)) return noTriangle(path, read.dropped);
    const bool guessed = options.up == Up::guess && lowerExtension(path) == ".stl";
    if (guessed || options.up == Up::z) standUp(scene);
    if (read.dropped > 0)
        warnings.push_back(
            asWarning({Code::not_finite,
                       "the scene '" + path + "' has " + std::to_string(read.dropped) +
                           " faces with vertices that are not finite or not there",
                       "they are left out"}));
    const std::size_t surfaces = turnInsideOut(scene);
    if (read.turned + surfaces > 0) warnings.push_back(turnedWarning(path, read.turned, surfaces));
    normalizeLights(scene);
    if (!options.blended_solid) append(warnings, setBlendedApart(scene, path));
    return {std::move(scene), std::move(warnings)};
}

Result<ReadScene> readByFormat(const std::string& path, const ImportOptions& options,
                               SceneFolder& folder, Diagnostics& warnings)
{
    try {
        return isGltf(path) ? readGltf(path, options, folder, warnings)
                            : readByAssimp(path, options, folder, warnings);
    } catch (const BrokenGltf& fault) {
        return brokenScene(path, fault.what(),
                           "export it once more; a glTF validator says more about it");
    }
}

}  // namespace

bool isDefaultFormat(const std::string& path)
{
    const std::string extension = lowerExtension(path);
    return !extension.empty() && contains(kDefaultFormats, std::string_view(extension).substr(1));
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

void setVertex(Vertex& vertex, const float* position, const float* normal)
{
    const glm::dvec3 given = normal ? glm::dvec3(glm::make_vec3(normal)) : glm::dvec3(0.0);
    const double length = glm::length(given);
    const bool usable = length > 0 && std::isfinite(length);
    for (int axis = 0; axis < 3; ++axis) {
        vertex.position[axis] = position[axis] + 0.0f;
        vertex.normal[axis] = usable ? static_cast<float>(given[axis] / length) + 0.0f : 0.0f;
    }
}

bool isGltf(const std::string& path)
{
    const std::string extension = lowerExtension(path);
    return extension == ".gltf" || extension == ".glb";
}

Result<Scene> readScene(const std::string& path, const ImportOptions& options)
{
    SceneFolder folder(path, options);
    Diagnostics warnings;
    Result<ReadScene> read = readByFormat(path, options, folder, warnings);
    if (!read && folder.refusedAny()) {
        Diagnostics errors = read.diagnostics();
        errors.front().notes.push_back({{}, folder.warning().message});
        errors.front().help = folder.warning().help;
        return errors;
    }
    if (!read) return read.diagnostics();
    if (folder.refusedAny()) warnings.push_back(folder.warning());
    limitSelf(readerLimits(kAnySize, options));  // what follows is our own, and bounded
    return finished(std::move(*read), path, options, std::move(warnings));
}

}  // namespace crevice
