// SPDX-License-Identifier: MIT
// A scene's objects on a device, and frames of them.
#include "tools/render/scene_upload.h"

#include "tools/render/scene/mesh_normals.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crevice {
namespace {

glm::vec3 pointOf(const Vertex& vertex)
{
    return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

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
    UploadedScene uploaded(device);
    if (Status status = uploaded.uploadTextures(scene); !status) return status.diagnostics();
    if (Status status = uploaded.uploadMeshes(scene); !status) return status.diagnostics();
    for (const SceneLight& light : scene.lights) uploaded.frame_.lights.push_back(light.light);
    uploaded.frame_.ambient_light = scene.ambient_light;
    uploaded.bounds_ = scene.bounds();
    return uploaded;
}

UploadedScene::~UploadedScene() { destroy(); }

UploadedScene::UploadedScene(UploadedScene&& other) noexcept
    : device_(other.device_),
      textures_(std::exchange(other.textures_, {})),
      meshes_(std::exchange(other.meshes_, {})),
      frame_(std::exchange(other.frame_, {})),
      bounds_(other.bounds_)
{
}

UploadedScene& UploadedScene::operator=(UploadedScene&& other) noexcept
{
    if (this == &other) return *this;
    destroy();
    device_ = other.device_;
    textures_ = std::exchange(other.textures_, {});
    meshes_ = std::exchange(other.meshes_, {});
    frame_ = std::exchange(other.frame_, {});
    bounds_ = other.bounds_;
    return *this;
}

Status UploadedScene::uploadTextures(const Scene& scene)
{
    for (const SceneTexture& texture : scene.textures) {
        const Result<TextureId> id =
            device_->createTexture({texture.name, Format::rgba16f, texture.image.extent});
        if (!id) return id.diagnostics();
        textures_.push_back(*id);
        if (Status status = device_->writeTexture(*id, texture.image); !status) return status;
    }
    for (const SceneMaterial& from : scene.materials) {
        Material material;
        material.base_color = from.base_color;
        if (from.base_color_texture >= 0)
            material.base_color_map = textures_[from.base_color_texture];
        material.specular = from.specular;
        material.shininess = from.shininess;
        material.alpha_cutoff = from.alpha_cutoff;
        if (from.normal_texture >= 0) material.normal_map = textures_[from.normal_texture];
        material.normal_scale = from.normal_scale;
        if (from.occlusion_texture >= 0) material.occlusion_map = textures_[from.occlusion_texture];
        material.occlusion_strength = from.occlusion_strength;
        frame_.materials.push_back(material);
    }
    return {};
}

Status UploadedScene::uploadMeshes(const Scene& scene)
{
    std::vector<DrawItem> items;  // by mesh: all but the place and the material
    for (const MeshDesc& mesh : scene.meshes) {
        items.emplace_back();
        if (mesh.indices.empty()) continue;
        const Result<MeshId> id = device_->createMesh(mesh);
        if (!id) return id.diagnostics();
        meshes_.push_back(*id);
        items.back().mesh = *id;
        items.back().count = static_cast<std::uint32_t>(mesh.indices.size());
        items.back().sheet = isOpen(mesh);
        setBounds(items.back(), mesh);
    }
    for (const SceneInstance& instance : scene.instances) {
        DrawItem item = items[instance.mesh];
        if (!item.mesh) continue;
        item.world_from_model = instance.world_from_model;
        item.material = instance.material;
        frame_.draws.push_back(item);
    }
    return {};
}

void UploadedScene::destroy()
{
    for (const MeshId mesh : meshes_) device_->destroy(mesh);
    for (const TextureId texture : textures_) device_->destroy(texture);
    meshes_.clear();
    textures_.clear();
}

Frame makeFrame(const UploadedScene& scene, const SceneCamera& camera, Extent extent)
{
    Frame frame = scene.frame_;
    frame.camera.view_from_world = camera.view_from_world;
    frame.camera.clip_from_view = clipFromView(camera, extent, scene.bounds_);
    return frame;
}

}  // namespace crevice
