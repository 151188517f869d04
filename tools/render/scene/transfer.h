// SPDX-License-Identifier: MIT
// A scene as bytes between two programs of one version: one list of members serves both ways.
//
// A Pipe has `void bytes(void* data, std::size_t size)`, which sends or receives, and `bool
// holds(std::uint64_t size)`: false where it receives and is known to have less than that left. The
// bytes are the same whatever the size of a word; only the order of bytes is the machine's.
#pragma once

#include "tools/render/scene/scene.h"

#include <cstring>
#include <type_traits>

namespace crevice {

class BytesWriter {
public:
    void bytes(const void* data, std::size_t size)
    {
        if (size > 0) written_.append(static_cast<const char*>(data), size);
    }
    bool holds(std::uint64_t) const { return true; }
    std::string take() { return std::move(written_); }

private:
    std::string written_;
};

/// Receives what lies in memory, which must outlive it. After a failure every further byte is 0.
class BytesReader {
public:
    explicit BytesReader(std::string_view bytes) : left_(bytes) {}

    void bytes(void* data, std::size_t size)
    {
        if (size == 0) return;
        if (!holds(size)) {
            std::memset(data, 0, size);
            return;
        }
        std::memcpy(data, left_.data(), size);
        left_.remove_prefix(size);
    }

    bool holds(std::uint64_t size)
    {
        failed_ = failed_ || size > left_.size();
        return !failed_;
    }

    bool whole() const { return !failed_ && left_.empty(); }

private:
    std::string_view left_;
    bool failed_ = false;
};

/// What is sent as it lies in memory: it has no padding and no length of its own.
template <class T>
inline constexpr bool kIsPlain =
    (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_enum_v<T>;
template <int N, class T, glm::qualifier Q>
inline constexpr bool kIsPlain<glm::vec<N, T, Q>> = true;
template <int C, int R, class T, glm::qualifier Q>
inline constexpr bool kIsPlain<glm::mat<C, R, T, Q>> = true;
template <>
inline constexpr bool kIsPlain<Vertex> = sizeof(Vertex) == 8 * sizeof(float);

// The functions below find each other by the namespace of the pipe.

template <class Pipe, class... Members>
void transferAll(Pipe& pipe, Members&... members)
{
    (transfer(pipe, members), ...);
}

/// What is received takes memory as it comes, and not as its length says.
template <class Pipe, template <class...> class List, class Entry, class... Rest>
void transfer(Pipe& pipe, List<Entry, Rest...>& list)
{
    std::uint64_t size = list.size();
    pipe.bytes(&size, sizeof(size));
    if constexpr (kIsPlain<Entry>) {
        const bool holds = size <= UINT64_MAX / sizeof(Entry) && pipe.holds(size * sizeof(Entry));
        list.resize(holds ? static_cast<std::size_t>(size) : 0);
        pipe.bytes(list.data(), list.size() * sizeof(Entry));
    } else {
        for (std::size_t index = 0; index < size && pipe.holds(0); ++index) {
            if (index == list.size()) list.emplace_back();
            transfer(pipe, list[index]);
        }
    }
}

template <class Pipe>
void transfer(Pipe& pipe, bool& value)
{
    std::uint8_t byte = value ? 1 : 0;
    pipe.bytes(&byte, sizeof(byte));
    value = byte != 0;
}

// Bindings, so that a member that is added does not compile until it is sent as well.

template <class Pipe>
void transfer(Pipe& pipe, MeshDesc& mesh)
{
    auto& [label, vertices, indices, may_have_sheets] = mesh;
    transferAll(pipe, label, vertices, indices, may_have_sheets);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneMaterial& material)
{
    auto& [name, base_color, base_color_texture, specular, shininess, alpha_cutoff, normal_texture,
           normal_scale, occlusion_texture, occlusion_strength, blended, metallic, roughness,
           reflectance, metallic_roughness_texture, emission, emission_texture, unlit] = material;
    transferAll(pipe, name, base_color, base_color_texture, specular, shininess, alpha_cutoff,
                normal_texture, normal_scale, occlusion_texture, occlusion_strength, blended,
                metallic, roughness, reflectance, metallic_roughness_texture, emission,
                emission_texture, unlit);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneTexture& texture)
{
    auto& [name, image] = texture;
    auto& [extent, channels, pixels] = image;
    auto& [width, height] = extent;
    transferAll(pipe, name, width, height, channels, pixels);
}

template <class Pipe>
void transfer(Pipe& pipe, SceneInstance& instance)
{
    auto& [mesh, world_from_model, material] = instance;
    transferAll(pipe, mesh, world_from_model, material);
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
    auto& [directional, position, direction, color, attenuation, spot, inner, outer] = light;
    transferAll(pipe, name, directional, position, direction, color, attenuation, spot, inner,
                outer);
}

template <class Pipe>
void transfer(Pipe& pipe, Scene& scene)
{
    auto& [name, meshes, instances, blended, materials, textures, cameras, lights, ambient] = scene;
    transferAll(pipe, name, meshes, instances, blended, materials, textures, cameras, lights,
                ambient);
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
    static_assert(kIsPlain<T>, "list its members");
    pipe.bytes(&value, sizeof(value));
}

}  // namespace crevice
