// SPDX-License-Identifier: MIT
// A scene as bytes between two processes of one program: one list of members serves both ways.
#pragma once

#include "tools/cli/child_process.h"
#include "tools/scene/scene.h"

#include <type_traits>

namespace crevice {

template <class Pipe, class T>
void transfer(Pipe& pipe, T& value);

template <class Pipe, class... Members>
void transferAll(Pipe& pipe, Members&... members)
{
    (transfer(pipe, members), ...);
}

template <class Pipe, class List>
void transferList(Pipe& pipe, List& list)
{
    using Entry = typename List::value_type;
    std::size_t size = list.size();
    pipe.bytes(&size, sizeof(size));
    list.resize(size);
    if constexpr (std::is_trivially_copyable_v<Entry>)
        pipe.bytes(list.data(), size * sizeof(Entry));
    else
        for (Entry& entry : list) transfer(pipe, entry);
}

template <class Pipe>
void transfer(Pipe& pipe, std::string& text)
{
    transferList(pipe, text);
}

template <class Pipe, class Entry>
void transfer(Pipe& pipe, std::vector<Entry>& list)
{
    transferList(pipe, list);
}

// Bindings, so that a member that is added does not compile until it is sent as well.

template <class Pipe>
void transfer(Pipe& pipe, MeshDesc& mesh)
{
    auto& [label, vertices, indices] = mesh;
    transferAll(pipe, label, vertices, indices);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneMaterial& material)
{
    auto& [name, base_color, base_color_texture, specular, shininess, alpha_cutoff, normal_texture,
           normal_scale, occlusion_texture, occlusion_strength] = material;
    transferAll(pipe, name, base_color, base_color_texture, specular, shininess, alpha_cutoff,
                normal_texture, normal_scale, occlusion_texture, occlusion_strength);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneTexture& texture)
{
    auto& [name, image] = texture;
    auto& [extent, channels, pixels] = image;
    transferAll(pipe, name, extent, channels, pixels);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneCamera& camera)
{
    auto& [name, view_from_world, orthographic, fov, half_height, shift, near, far] = camera;
    transferAll(pipe, name, view_from_world, orthographic, fov, half_height, shift, near, far);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneLight& named)
{
    auto& [name, light] = named;
    transferAll(pipe, name, light);
}

template <class Pipe>
void transfer(Pipe& pipe, Scene& scene)
{
    auto& [name, meshes, instances, materials, textures, cameras, lights, ambient] = scene;
    transferAll(pipe, name, meshes, instances, materials, textures, cameras, lights, ambient);
}

/// Without places and notes: diagnostics of a scene have none.
template <class Pipe>
void transfer(Pipe& pipe, Diagnostic& diagnostic)
{
    transferAll(pipe, diagnostic.code, diagnostic.message, diagnostic.help, diagnostic.severity);
}

template <class Pipe, class T>
void transfer(Pipe& pipe, T& value)
{
    static_assert(std::is_trivially_copyable_v<T>, "list its members");
    pipe.bytes(&value, sizeof(value));
}

}  // namespace crevice
