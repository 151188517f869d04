// SPDX-License-Identifier: MIT
#include "tools/render/scene/scene_bytes.h"

#include "core/base/text.h"
#include "tools/render/scene/transfer.h"

namespace crevice {
namespace {

// "crvs" and a version, which goes up with every change of what is sent. As numbers, so that
// another order of bytes is seen.
constexpr std::uint32_t kMagic = 0x73767263;
constexpr std::uint32_t kVersion = 3;

Diagnostic broken(const std::string& reason)
{
    return Diagnostic{Code::scene_broken, "the bytes of a scene cannot be read: " + reason,
                      "write and read them with the same version of crevice"};
}

template <class List>
bool isIndex(const List& list, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

bool isSound(const MeshDesc& mesh)
{
    return mesh.indices.size() % 3 == 0 &&
           allOf(mesh.indices, [&](std::uint32_t index) { return index < mesh.vertices.size(); });
}

bool isSound(const Image& image)
{
    constexpr int kMaxSide = 1 << 15;  // as of images that are read
    const Extent& extent = image.extent;
    if (std::min({extent.width, extent.height, image.channels}) < 1) return false;
    if (std::max(extent.width, extent.height) > kMaxSide || image.channels > 4) return false;
    return image.pixels.size() ==
           static_cast<std::uint64_t>(extent.width) * extent.height * image.channels;
}

}  // namespace

bool isSound(const Scene& scene)
{
    for (const MeshDesc& mesh : scene.meshes)
        if (!isSound(mesh)) return false;
    for (const SceneTexture& texture : scene.textures)
        if (!isSound(texture.image)) return false;
    for (const auto* list : {&scene.instances, &scene.blended})
        for (const SceneInstance& each : *list)
            if (!isIndex(scene.meshes, each.mesh) || !isIndex(scene.materials, each.material))
                return false;
    for (const SceneMaterial& material : scene.materials)
        for (const int texture :
             {material.base_color_texture, material.normal_texture, material.occlusion_texture,
              material.metallic_roughness_texture, material.emission_texture})
            if (texture != -1 && !isIndex(scene.textures, texture)) return false;
    return true;
}

std::string sceneBytes(const Scene& scene)
{
    std::uint32_t magic = kMagic, version = kVersion;
    BytesWriter writer;
    transferAll(writer, magic, version, const_cast<Scene&>(scene));  // which a writer only reads
    return writer.take();
}

Result<Scene> sceneFromBytes(std::string_view bytes)
{
    std::uint32_t magic = 0, version = 0;
    BytesReader reader(bytes);
    transferAll(reader, magic, version);
    if (magic != kMagic) return broken("they do not begin as a scene does");
    if (version != kVersion)
        return broken("they have version " + std::to_string(version) + ", and " +
                      std::to_string(kVersion) + " was wanted");
    Scene scene;
    transfer(reader, scene);
    if (!reader.whole()) return broken("they are cut, or changed");
    if (!isSound(scene)) return broken("they refer to what is not in them");
    const bool drawn = anyOf(scene.instances, [&](const SceneInstance& each) {
        return !scene.meshes[each.mesh].indices.empty();
    });
    if (!drawn) return Diagnostic{Code::scene_empty, "the scene has no triangle"};
    return scene;
}

}  // namespace crevice
