// SPDX-License-Identifier: MIT
#include "core/gpu/mesh_edges.h"
#include "tools/render/scene/options.h"
#include "tools/show/plan/print.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace crevice {
namespace {

using Json = nlohmann::ordered_json;

// Of a closed surface, volume over area^1.5 that is more than floats round.
constexpr double kNoThickness = 1e-6;
// By the power of ten of a fifth of the diagonal.
const std::map<int, const char*> kUnits = {{0, "metres"}, {2, "centimetres"}, {3, "millimetres"}};

void addSurfaces(const MeshDesc& mesh, int places, std::map<std::string, int>& kinds)
{
    const auto at = [&](std::size_t corner) {
        const float* const place = mesh.vertices[mesh.indices[corner]].position;
        return glm::dvec3(place[0], place[1], place[2]);
    };
    std::map<std::uint32_t, std::pair<double, double>> surfaces;  // area, volume
    std::set<std::uint32_t> open;
    const std::vector<std::uint32_t> numbers = surfacesOf(mesh);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const glm::dvec3 a = at(3 * k), b = at(3 * k + 1) - a, c = at(3 * k + 2) - a;
        auto& [area, volume] = surfaces[numbers[k]];
        area += glm::length(glm::cross(b, c)) / 2;
        volume += glm::dot(a - at(0), glm::cross(b, c)) / 6;
    }
    surfaces.erase(kNoSurface);
    for (const std::uint32_t first : sheetsOf(mesh)) open.insert(numbers[first / 3]);
    for (const auto& [number, size] : surfaces) {
        const bool thin = std::abs(size.second) < kNoThickness * std::pow(size.first, 1.5);
        kinds[open.count(number) ? "open" : thin ? "sheets" : "closed"] += places;
    }
}

Json geometryOf(const Scene& scene)
{
    std::vector<int> uses(scene.meshes.size());
    for (const SceneInstance& each : scene.instances) ++uses[each.mesh];
    std::map<std::string, int> kinds = {{"closed", 0}, {"sheets", 0}, {"open", 0}};
    std::size_t count = scene.instances.size(), vertices = 0;
    for (std::size_t k = 0; k < uses.size(); ++k) {
        vertices += scene.meshes[k].vertices.size() * uses[k];
        if (uses[k] > 0) addSurfaces(scene.meshes[k], uses[k], kinds);
    }
    const Bounds box = scene.bounds();
    const auto& [low, high] = box;
    const auto unit = kUnits.find(int(std::floor(std::log10(box.diagonal() / 5))));
    Json all = {{"scene", scene.name}};
    all["geometry"] = {{"meshes", uses.size()},
                       {"places", count},
                       {"triangles", triangleCount(scene)},
                       {"vertices", vertices}};
    all["surfaces"] = kinds;
    all["bounds"] = {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}};
    all["size"] = {{"diagonal", box.diagonal()},
                   {"unit", unit != kUnits.end() ? unit->second : "unknown"}};
    return all;
}

}  // namespace

Result<Json> inspectScene(const std::string& name, const ImportOptions& options)
{
    ImportOptions whole = options;
    whole.blended_solid = true;
    const Result<Scene> scene = loadScene(name, whole);
    if (!scene) return scene.diagnostics();
    Json all = geometryOf(*scene);
    for (const char* list : {"materials", "textures", "cameras", "lights", "left_out"})
        all[list] = Json::array();
    for (const SceneMaterial& each : scene->materials) {
        Json textures = Json::object();
        for (const auto& [use, index] : {std::pair("colour", each.base_color_texture),
                                         {"normal", each.normal_texture},
                                         {"occlusion", each.occlusion_texture},
                                         {"metal", each.metallic_roughness_texture},
                                         {"emission", each.emission_texture}})
            if (index >= 0) textures[use] = scene->textures[index].name;
        all["materials"].push_back({{"name", each.name},
                                    {"cut_out", each.alpha_cutoff > 0},
                                    {"seen_through", each.blended},
                                    {"alpha", each.base_color.a},
                                    {"metallic", each.metallic},
                                    {"roughness", each.roughness},
                                    {"emits", each.emission != glm::vec3(0.0f)},
                                    {"unlit", each.unlit},
                                    {"textures", textures}});
    }
    for (const auto& [texture, image] : scene->textures)
        all["textures"].push_back({{"name", texture}, {"size", sizeText(image.extent)}});
    for (const SceneCamera& each : scene->cameras) all["cameras"].push_back(each.name);
    for (const auto& [light, is] : scene->lights) {
        const char* const kind = is.directional ? "directional" : is.spot ? "spot" : "point";
        all["lights"].push_back({{"name", light}, {"kind", kind}});
    }
    for (const Diagnostic& each : scene.diagnostics())
        all["left_out"].push_back({{"code", codeName(each.code)}, {"message", each.message}});
    return all;
}

}  // namespace crevice
