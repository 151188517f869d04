// SPDX-License-Identifier: MIT
// A scene out of a file that JavaScript reads, src/engine/gltf.js: JSON, and the bytes of its
// arrays.
#include "tools/show/page/engine/answers.h"

#include "tools/render/image/srgb.h"
#include "tools/render/scene/lights.h"
#include "tools/render/scene/mesh_normals.h"

#include <glm/gtc/matrix_transform.hpp>

namespace crevice::page {
namespace {

/// The array that begins at byte json[key].
template <class T>
const T* arrayIn(const Json& json, const char* key, const char* bytes)
{
    return reinterpret_cast<const T*>(bytes + json[key].get<std::size_t>());
}

glm::dvec3 vectorIn(const Json& json, const char* key)
{
    return {json[key][0].get<double>(), json[key][1].get<double>(), json[key][2].get<double>()};
}

/// Texels of 4 bytes, lowest row first.
SceneTexture textureIn(const Json& json, const char* bytes)
{
    const auto* texels = arrayIn<std::uint8_t>(json, "rows", bytes);
    Image linear({json["width"].get<int>(), json["height"].get<int>()}, 4);
    float table[256];
    for (int i = 0; i < 256; ++i) {
        const float value = static_cast<float>(i) / 255.0f;
        table[i] = json["srgb"].get<bool>() ? linearFromSrgb(value) : value;
    }
    for (std::size_t i = 0; i < linear.pixels.size(); ++i)
        linear.pixels[i] = i % 4 == 3 ? static_cast<float>(texels[i]) / 255.0f : table[texels[i]];
    return {json.value("name", ""), std::move(linear)};
}

SceneMaterial materialIn(const Json& json)
{
    SceneMaterial material;
    material.name = json.value("name", "");
    for (int i = 0; i < 4; ++i) material.base_color[i] = json["base_color"][i].get<float>();
    material.base_color_texture = json.value("base_color_texture", -1);
    material.alpha_cutoff = json.value("alpha_cutoff", 0.0f);
    material.normal_texture = json.value("normal_texture", -1);
    material.normal_scale = json.value("normal_scale", 1.0f);
    material.occlusion_texture = json.value("occlusion_texture", -1);
    material.occlusion_strength = json.value("occlusion_strength", 1.0f);
    return material;
}

/// Vertices of 8 floats: position, normal, uv. Where the file has no normals they are made.
MeshDesc meshIn(const Json& json, const char* bytes)
{
    const auto* vertices = arrayIn<Vertex>(json, "vertices", bytes);
    const auto* indices = arrayIn<std::uint32_t>(json, "indices", bytes);
    MeshDesc mesh;
    mesh.label = json.value("name", "");
    mesh.vertices.assign(vertices, vertices + json["vertex_count"].get<std::size_t>());
    mesh.indices.assign(indices, indices + json["index_count"].get<std::size_t>());
    finishMesh(mesh, json["has_normals"].get<bool>(), kGltfCreaseDegrees);
    return mesh;
}

SceneInstance instanceIn(const Json& json, const char* bytes)
{
    const auto* matrix = arrayIn<double>(json, "world_from_model", bytes);
    SceneInstance instance;
    instance.mesh = json["mesh"].get<int>();
    instance.material = json["material"].get<int>();
    for (int i = 0; i < 16; ++i) instance.world_from_model[i / 4][i % 4] = matrix[i];
    return instance;
}

SceneCamera cameraIn(const Json& json)
{
    const glm::dvec3 eye = vectorIn(json, "eye");
    SceneCamera camera;
    camera.name = json.value("name", "");
    camera.view_from_world = glm::lookAt(eye, eye - vectorIn(json, "back"), vectorIn(json, "up"));
    camera.orthographic = json.contains("half_height");
    camera.half_height = json.value("half_height", camera.half_height);
    camera.fov_y_rad = json.value("fov_y_rad", camera.fov_y_rad);
    return camera;
}

SceneLight lightIn(const Json& json)
{
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
    return light;
}

}  // namespace

EXPORT const char* page_show_model(const char* text, const char* bytes)
{
    Json json = Json::parse(text);
    Scene scene;
    scene.name = json.value("name", "");
    for (const Json& each : json["textures"]) scene.textures.push_back(textureIn(each, bytes));
    for (const Json& each : json["materials"]) scene.materials.push_back(materialIn(each));
    for (const Json& each : json["meshes"]) scene.meshes.push_back(meshIn(each, bytes));
    for (const Json& each : json["instances"]) scene.instances.push_back(instanceIn(each, bytes));
    for (const Json& each : json["cameras"]) scene.cameras.push_back(cameraIn(each));
    for (const Json& each : json["lights"]) scene.lights.push_back(lightIn(each));
    if (scene.materials.empty()) scene.materials.emplace_back();
    normalizeLights(scene);
    addDefaultLight(scene);
    return say(answer(engine.stage().show(std::move(scene))));
}

}  // namespace crevice::page
