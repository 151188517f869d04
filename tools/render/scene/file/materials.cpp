// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/import.h"

#include "tools/render/image/image_file.h"
#include "tools/render/image/srgb.h"
#include "tools/render/scene/file/folder.h"
#include "tools/render/scene/file/limits.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <new>

namespace crevice {

namespace {

// Exponents above it are mirrors, which a single highlight cannot show.
constexpr float kMaxShininess = 1000.0f;

// Of an image file. A picture of 8192 x 8192 pixels that nothing compresses takes 256 MiB.
constexpr std::uintmax_t kMaxTextureBytes = 512u << 20;

enum class Encoding { srgb, linear };

// Four linear channels of an image with any number of channels.
Image linearRgba(const Image& image, Encoding encoding)
{
    Image rgba(image.extent, 4, 1.0f);
    const std::size_t count = rgba.pixels.size() / 4;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const float* from = &image.pixels[pixel * image.channels];
        float* to = &rgba.pixels[pixel * 4];
        for (int channel = 0; channel < 3; ++channel) {
            const float value = image.channels >= 3 ? from[channel] : from[0];
            to[channel] = encoding == Encoding::srgb ? linearFromSrgb(value) : value;
        }
        if (image.channels % 2 == 0) to[3] = from[image.channels - 1];
    }
    return rgba;
}

// "Base%20Color.png" as URIs write it.
std::string percentDecoded(const std::string& text)
{
    std::string decoded;
    for (std::size_t at = 0; at < text.size(); ++at) {
        unsigned code = 0;
        const char* const digits = text.data() + at + 1;
        const bool escape = text[at] == '%' && at + 2 < text.size() &&
                            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
        decoded += escape ? static_cast<char>(code) : text[at];
        if (escape) at += 2;
    }
    return decoded;
}

// Exporters write paths of their own machine: what follows the last slash is tried as well. Nothing
// where the only such file is one that the folder does not open.
std::optional<std::string> textureFile(const std::string& scene_path, SceneFolder& allowed,
                                       std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    const std::filesystem::path folder = std::filesystem::path(scene_path).parent_path();
    std::vector<std::filesystem::path> candidates;
    for (const std::string& spelling : {name, percentDecoded(name)})
        for (const std::filesystem::path& path :
             {std::filesystem::path(spelling), std::filesystem::path(spelling).filename()})
            candidates.push_back(folder / path);
    for (const auto& candidate : candidates)
        if (allowed.allows(candidate)) return candidate.string();
    for (const auto& candidate : candidates)
        if (allowed.refuses(candidate)) return std::nullopt;
    return (folder / name).string();
}

// A texture that the scene file carries as plain texels, rows from the top down.
Image imageFromTexels(const aiTexture& texture)
{
    Image image({static_cast<int>(texture.mWidth), static_cast<int>(texture.mHeight)}, 4);
    for (int y = 0; y < image.extent.height; ++y) {
        for (int x = 0; x < image.extent.width; ++x) {
            const std::size_t row = image.extent.height - 1 - y;
            const aiTexel& texel = texture.pcData[row * texture.mWidth + x];
            const unsigned char values[4] = {texel.r, texel.g, texel.b, texel.a};
            for (int channel = 0; channel < 4; ++channel)
                image.at(x, y, channel) = values[channel] / 255.0f;
        }
    }
    return image;
}

Result<Image> readImageFile(const std::string& file, double most_pixels)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error && size > kMaxTextureBytes)
        return Diagnostic{Code::image_broken, "the image '" + file + "' is larger than 512 MiB"};
    return readImage(file, most_pixels);
}

// Nothing where the file is not one to open. All textures of a scene have `texels` already.
std::optional<Result<Image>> readTexture(const aiScene& from, const std::string& scene_path,
                                         SceneFolder& folder, const std::string& name,
                                         double texels)
{
    const aiTexture* embedded = from.GetEmbeddedTexture(name.c_str());
    if (!embedded) {
        const std::optional<std::string> file = textureFile(scene_path, folder, name);
        if (!file) return std::nullopt;
        folder.opens(*file);
        return readImageFile(*file, sceneLimits(folder.bytes()).texels - texels);
    }
    if (embedded->mHeight > 0) return imageFromTexels(*embedded);
    const std::string_view bytes(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
    return decodeImage(bytes, scene_path + " (embedded texture " + name + ")",
                       sceneLimits(folder.bytes()).texels - texels);
}

// Reads each texture once, whichever materials use it.
struct TextureImport {
    static constexpr int kNone = -1;

    /// Index of the material's texture; kNone when it has none that can be read.
    int find(const aiMaterial& material, aiTextureType type, Encoding encoding)
    {
        aiString name;
        if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS) return kNone;
        const auto [known, added] = indices.try_emplace({name.C_Str(), encoding}, kNone);
        if (added) known->second = read(name.C_Str(), encoding);
        return known->second;
    }

    int read(const std::string& name, Encoding encoding)
    {
        try {
            const std::optional<Result<Image>> image =
                readTexture(from, path, folder, name, texels);
            if (!image) return kNone;
            if (!*image) return leaveOut(image->diagnostics().front());
            scene.textures.push_back({name, linearRgba(**image, encoding)});
            texels += static_cast<double>(scene.textures.back().image.pixels.size()) / 4;
            return static_cast<int>(scene.textures.size()) - 1;
        } catch (const std::bad_alloc&) {
            return leaveOut(
                {Code::image_broken, "the image '" + name + "' does not fit into memory"});
        }
    }

    int leaveOut(Diagnostic warning)
    {
        warning.severity = Severity::warning;
        if (!warning.help.empty()) warning.help += "; ";
        warning.help += "the material is drawn without the texture";
        warnings.push_back(std::move(warning));
        return kNone;
    }

    const aiScene& from;
    const std::string& path;
    SceneFolder& folder;
    Scene& scene;
    Diagnostics& warnings;
    std::map<std::pair<std::string, Encoding>, int> indices = {};
    double texels = 0;  // of what was read
};

float finiteOr(float value, float otherwise) { return std::isfinite(value) ? value : otherwise; }

glm::vec3 specularOf(const aiMaterial& from)
{
    aiColor3D color(0, 0, 0);
    float strength = 1.0f;
    from.Get(AI_MATKEY_COLOR_SPECULAR, color);
    from.Get(AI_MATKEY_SHININESS_STRENGTH, strength);
    const glm::vec3 specular = glm::vec3(color.r, color.g, color.b) * strength;
    return {finiteOr(specular.x, 0), finiteOr(specular.y, 0), finiteOr(specular.z, 0)};
}

SceneMaterial materialFrom(const aiMaterial& from)
{
    SceneMaterial material;
    material.name = from.GetName().C_Str();
    aiColor4D color(0.8f, 0.8f, 0.8f, 1.0f);
    if (from.Get(AI_MATKEY_BASE_COLOR, color) != aiReturn_SUCCESS)
        from.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    material.base_color = {finiteOr(color.r, 0.8f), finiteOr(color.g, 0.8f),
                           finiteOr(color.b, 0.8f), finiteOr(color.a, 1.0f)};

    // Without an exponent there is no highlight to speak of: formats leave both at odd defaults.
    float shininess = 0.0f;
    from.Get(AI_MATKEY_SHININESS, shininess);
    if (std::isfinite(shininess) && shininess > 0.0f) {
        material.shininess = std::clamp(shininess, 1.0f, kMaxShininess);
        material.specular = specularOf(from);
    }

    aiString mode;
    if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS && mode == aiString("MASK")) {
        material.alpha_cutoff = 0.5f;
        from.Get(AI_MATKEY_GLTF_ALPHACUTOFF, material.alpha_cutoff);
    }
    return material;
}

// Assimp calls glTF's occlusionTexture a light map.
void importSurfaceMaps(const aiMaterial& from, TextureImport& textures, SceneMaterial& material)
{
    material.normal_texture = textures.find(from, aiTextureType_NORMALS, Encoding::linear);
    from.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), material.normal_scale);
    material.normal_scale = finiteOr(material.normal_scale, 1.0f);

    aiString gltf;  // only glTF has alpha modes; elsewhere a light map is a light map
    if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, gltf) != aiReturn_SUCCESS) return;
    material.occlusion_texture = textures.find(from, aiTextureType_LIGHTMAP, Encoding::linear);
    from.Get(AI_MATKEY_GLTF_TEXTURE_STRENGTH(aiTextureType_LIGHTMAP, 0),
             material.occlusion_strength);
    material.occlusion_strength = std::clamp(finiteOr(material.occlusion_strength, 1), 0.0f, 1.0f);
}

}  // namespace

void importMaterials(const aiScene& from, const std::string& path, SceneFolder& folder,
                     Scene& scene, Diagnostics& warnings)
{
    TextureImport textures = {from, path, folder, scene, warnings};
    for (unsigned index = 0; index < from.mNumMaterials; ++index) {
        const aiMaterial& each = *from.mMaterials[index];
        SceneMaterial material = materialFrom(each);
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
            if (material.base_color_texture == TextureImport::kNone)
                material.base_color_texture = textures.find(each, type, Encoding::srgb);
        importSurfaceMaps(each, textures, material);
        scene.materials.push_back(std::move(material));
    }
    if (scene.materials.empty()) scene.materials.emplace_back();
}

}  // namespace crevice
