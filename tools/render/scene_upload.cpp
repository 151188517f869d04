// SPDX-License-Identifier: MIT
#include "tools/render/scene_upload.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {
namespace {

glm::vec3 pointOf(const Vertex& vertex) { return glm::make_vec3(vertex.position); }

/// A sphere about the middle of the mesh's box.
void setBounds(DrawItem& item, const MeshDesc& mesh)
{
    glm::vec3 low = pointOf(mesh.vertices.front());
    glm::vec3 high = low;
    for (const Vertex& vertex : mesh.vertices) {
        low = glm::min(low, pointOf(vertex));
        high = glm::max(high, pointOf(vertex));
    }
    const glm::vec3 center = low * 0.5f + high * 0.5f;
    float farthest = 0.0f;
    for (const Vertex& vertex : mesh.vertices) {
        const float away = glm::length(pointOf(vertex) - center);
        if (!std::isfinite(away)) return;  // no sphere holds such a mesh
        farthest = std::max(farthest, away);
    }
    item.bounds_center = center;
    item.bounds_radius = farthest;
}

}  // namespace

Result<UploadedScene> UploadedScene::upload(Device& device, const Scene& scene)
{
    UploadedScene uploaded;
    if (Status status = uploaded.uploadTextures(device, scene); !status)
        return status.diagnostics();
    if (Status status = uploaded.uploadMeshes(device, scene); !status) return status.diagnostics();
    for (const SceneLight& light : scene.lights) uploaded.frame_.lights.push_back(light.light);
    uploaded.frame_.ambient_light = scene.ambient_light;
    uploaded.bounds_ = scene.bounds();
    return uploaded;
}

Status UploadedScene::uploadTextures(Device& device, const Scene& scene)
{
    for (const SceneTexture& texture : scene.textures) {
        const Result<TextureId> id =
            device.createTexture({texture.name, Format::rgba16f, texture.image.extent});
        if (!id) return id.diagnostics();
        textures_.emplace_back(device, *id);
        if (Status status = device.writeTexture(*id, texture.image); !status) return status;
    }
    const auto textureOf = [&](int index) {
        return index < 0 ? TextureId() : textures_[index].id();
    };
    for (const SceneMaterial& from : scene.materials) {
        Material material;
        material.base_color = from.base_color;
        material.base_color_map = textureOf(from.base_color_texture);
        material.specular = from.specular;
        material.shininess = from.shininess;
        material.alpha_cutoff = from.alpha_cutoff;
        material.normal_map = textureOf(from.normal_texture);
        material.normal_scale = from.normal_scale;
        material.occlusion_map = textureOf(from.occlusion_texture);
        material.occlusion_strength = from.occlusion_strength;
        material.metallic = from.metallic;
        material.roughness = from.roughness;
        material.reflectance = from.reflectance;
        material.metallic_roughness_map = textureOf(from.metallic_roughness_texture);
        material.emission = from.emission;
        material.emission_map = textureOf(from.emission_texture);
        material.unlit = from.unlit;
        frame_.materials.push_back(material);
    }
    return {};
}

Status UploadedScene::uploadMeshes(Device& device, const Scene& scene)
{
    std::vector<DrawItem> items;  // by mesh: all but the place and the material
    for (const MeshDesc& mesh : scene.meshes) {
        items.emplace_back();
        if (mesh.indices.empty()) continue;
        const Result<MeshId> id = device.createMesh(mesh);
        if (!id) return id.diagnostics();
        meshes_.emplace_back(device, *id);
        items.back().mesh = *id;
        items.back().count = static_cast<std::uint32_t>(mesh.indices.size());
        setBounds(items.back(), mesh);
    }
    const auto draw = [&](const SceneInstance& instance) {
        DrawItem item = items[instance.mesh];
        if (!item.mesh) return;
        item.world_from_model = instance.world_from_model;
        item.material = instance.material;
        frame_.draws.push_back(item);
    };
    for (const SceneInstance& each : scene.instances) draw(each);
    for (const SceneInstance& each : scene.blended) {
        draw(each);
        frame_.materials[each.material].blended = true;
    }
    return {};
}

Frame makeFrame(const UploadedScene& scene, const SceneCamera& camera, Extent extent)
{
    Frame frame = scene.frame_;
    frame.camera.view_from_world = camera.view_from_world;
    frame.camera.clip_from_view = clipFromView(camera, extent, scene.bounds_);
    frame.scale.diagonal = scene.bounds_.diagonal();
    return frame;
}

}  // namespace crevice
