// SPDX-License-Identifier: MIT
// A scene out of a file that JavaScript reads: begun, filled, shown. src/engine/gltf.js is its
// other side.
#include "tools/page/engine/answers.h"

#include "tools/image/srgb.h"
#include "tools/scene/lights.h"
#include "tools/scene/mesh_normals.h"

#include <glm/gtc/matrix_transform.hpp>

using namespace crevice;
using namespace crevice::page;

namespace {

Scene building;

glm::dvec3 vectorIn(const Json& json, const char* key)
{
    return {json[key][0].get<double>(), json[key][1].get<double>(), json[key][2].get<double>()};
}

}  // namespace

/// Begins a scene that the calls below fill, and page_build_end shows.
EXPORT void page_build_begin(const char* name)
{
    building = Scene();
    building.name = name;
}

/// Texels of 4 bytes, lowest row first. Gives its index.
EXPORT int page_build_texture(const char* name, int width, int height, const std::uint8_t* texels,
                              int srgb)
{
    Image linear({width, height}, 4);
    float table[256];
    for (int i = 0; i < 256; ++i) {
        const float value = static_cast<float>(i) / 255.0f;
        table[i] = srgb ? linearFromSrgb(value) : value;
    }
    for (std::size_t i = 0; i < linear.pixels.size(); ++i)
        linear.pixels[i] = i % 4 == 3 ? static_cast<float>(texels[i]) / 255.0f : table[texels[i]];
    building.textures.push_back({name, std::move(linear)});
    return static_cast<int>(building.textures.size()) - 1;
}

EXPORT void page_build_material(const char* text)
{
    const Json json = Json::parse(text);
    SceneMaterial material;
    material.name = json.value("name", "");
    for (int i = 0; i < 4; ++i) material.base_color[i] = json["base_color"][i].get<float>();
    material.base_color_texture = json.value("base_color_texture", -1);
    material.alpha_cutoff = json.value("alpha_cutoff", 0.0f);
    material.normal_texture = json.value("normal_texture", -1);
    material.normal_scale = json.value("normal_scale", 1.0f);
    material.occlusion_texture = json.value("occlusion_texture", -1);
    material.occlusion_strength = json.value("occlusion_strength", 1.0f);
    building.materials.push_back(std::move(material));
}

/// Vertices of 8 floats: position, normal, uv. Where the file has no normals they are made.
EXPORT int page_build_mesh(const char* name, const Vertex* vertices, int vertex_count,
                           const std::uint32_t* indices, int index_count, int has_normals)
{
    MeshDesc mesh;
    mesh.label = name;
    mesh.vertices.assign(vertices, vertices + vertex_count);
    mesh.indices.assign(indices, indices + index_count);
    finishMesh(mesh, has_normals != 0, kGltfCreaseDegrees);
    building.meshes.push_back(std::move(mesh));
    return static_cast<int>(building.meshes.size()) - 1;
}

EXPORT void page_build_instance(int mesh, int material, const double* world_from_model)
{
    SceneInstance instance;
    instance.mesh = mesh;
    instance.material = material;
    for (int i = 0; i < 16; ++i) instance.world_from_model[i / 4][i % 4] = world_from_model[i];
    building.instances.push_back(instance);
}

EXPORT void page_build_camera(const char* text)
{
    const Json json = Json::parse(text);
    const glm::dvec3 eye = vectorIn(json, "eye");
    SceneCamera camera;
    camera.name = json.value("name", "");
    camera.view_from_world = glm::lookAt(eye, eye - vectorIn(json, "back"), vectorIn(json, "up"));
    camera.orthographic = json.contains("half_height");
    camera.half_height = json.value("half_height", camera.half_height);
    camera.fov_y_rad = json.value("fov_y_rad", camera.fov_y_rad);
    building.cameras.push_back(std::move(camera));
}

EXPORT void page_build_light(const char* text)
{
    const Json json = Json::parse(text);
    const std::string type = json.value("type", "point");
    SceneLight light;
    light.name = json.value("name", "");
    light.light.directional = type == "directional";
    light.light.spot = type == "spot";
    light.light.position = vectorIn(json, "position");
    light.light.direction = vectorIn(json, "direction");
    light.light.color = glm::vec3(vectorIn(json, "color")) * json.value("intensity", 1.0f);
    light.light.attenuation = {0, 0, 1};
    light.light.inner_angle_rad = json.value("inner", 0.0f);
    light.light.outer_angle_rad = json.value("outer", 0.8f);
    building.lights.push_back(std::move(light));
}

EXPORT const char* page_build_end()
{
    if (building.materials.empty()) building.materials.emplace_back();
    normalizeLights(building);
    addDefaultLight(building);
    return say(answer(engine.stage().show(std::move(building))));
}
