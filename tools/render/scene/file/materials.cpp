// SPDX-License-Identifier: MIT
// Materials of Assimp's.
#include "tools/render/scene/file/import.h"
#include "tools/render/scene/file/textures.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

// Exponents above it are mirrors, which a single highlight cannot show.
constexpr float kMaxShininess = 1000.0f;

// What an opaque surface may say of itself: some exporters round.
constexpr float kOpaque = 0.99f;

// Alpha below it is a hole where a file says only that there are some.
constexpr float kCutoff = 0.5f;

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

int textureOf(const aiScene& from, const aiMaterial& material, aiTextureType type,
              Encoding encoding, SceneTextures& textures)
{
    aiString path;
    if (material.GetTexture(type, 0, &path) != aiReturn_SUCCESS) return SceneTextures::kNone;
    const std::string name = path.C_Str();
    const aiTexture* const embedded = from.GetEmbeddedTexture(name.c_str());
    if (!embedded) return textures.inFile(name, encoding);
    if (embedded->mHeight > 0) return textures.inImage(name, imageFromTexels(*embedded), encoding);
    return textures.inBytes(
        name, {reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth}, encoding);
}

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
        material.roughness = std::pow(2.0f / (material.shininess + 2.0f), 0.25f);
    }
    aiColor3D glow(0, 0, 0);
    from.Get(AI_MATKEY_COLOR_EMISSIVE, glow);
    material.emission = {finiteOr(glow.r, 0), finiteOr(glow.g, 0), finiteOr(glow.b, 0)};

    float opacity = 1.0f;
    from.Get(AI_MATKEY_OPACITY, opacity);
    material.blended = opacity > 0 && opacity < kOpaque;  // 0 is how exporters get it wrong
    return material;
}

// The colours of one image and, as alpha, the other: its own alpha, or its red where it has none.
Image withHoles(const Image* color, const Image& holes)
{
    bool alpha = false;
    for (std::size_t k = 3; k < holes.pixels.size() && !alpha; k += 4) alpha = holes.pixels[k] < 1;
    const Extent size = color ? color->extent : holes.extent;
    Image joined = color ? *color : Image(size, 4, 1.0f);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::int64_t column = std::int64_t{x} * holes.extent.width / size.width;
            const std::int64_t row = std::int64_t{y} * holes.extent.height / size.height;
            joined.at(x, y, 3) =
                holes.at(static_cast<int>(column), static_cast<int>(row), alpha ? 3 : 0);
        }
    return joined;
}

// Where the material's map of opacity, or the alpha of its colours, has holes. The latter may be
// something else, such as a mask of highlights, where it is mostly neither clear nor solid.
void importHoles(int holes, SceneTextures& textures, Scene& scene, SceneMaterial& material,
                 LeftOut& left_out)
{
    int& color = material.base_color_texture;
    const auto imageOf = [&](int index) { return &scene.textures[std::size_t(index)].image; };
    if (holes >= 0) {
        Image joined = withHoles(color < 0 ? nullptr : imageOf(color), *imageOf(holes));
        color =
            textures.add(scene.textures[std::size_t(holes)].name + " as holes", std::move(joined));
    }
    if (color < 0) return;
    const auto [vague, least] = alphaOf(*imageOf(color));
    if (least >= kCutoff) return;
    if (holes >= 0 || vague < kMostVague)
        material.alpha_cutoff = kCutoff;
    else
        left_out.look.insert("alpha of map_Kd that is no cut-out");
}

}  // namespace

std::pair<double, float> alphaOf(const Image& image)
{
    double vague = 0;
    float least = 1;
    for (std::size_t k = 3; k < image.pixels.size(); k += 4) {
        vague += image.pixels[k] > kClear && image.pixels[k] < kSolid;
        least = std::min(least, image.pixels[k]);
    }
    return {vague * 4 / static_cast<double>(std::max<std::size_t>(image.pixels.size(), 1)), least};
}

void importMaterials(const aiScene& from, SceneTextures& textures, Scene& scene, LeftOut& left_out)
{
    for (unsigned index = 0; index < from.mNumMaterials; ++index) {
        const aiMaterial& each = *from.mMaterials[index];
        SceneMaterial material = materialFrom(each);
        const auto texture = [&](aiTextureType type, Encoding encoding) {
            return textureOf(from, each, type, encoding, textures);
        };
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE})
            if (material.base_color_texture == SceneTextures::kNone)
                material.base_color_texture = texture(type, Encoding::srgb);
        material.normal_texture = texture(aiTextureType_NORMALS, Encoding::linear);
        material.emission_texture = texture(aiTextureType_EMISSIVE, Encoding::srgb);
        if (material.emission_texture >= 0 && material.emission == glm::vec3(0.0f))
            material.emission = glm::vec3(1.0f);
        importHoles(texture(aiTextureType_OPACITY, Encoding::linear), textures, scene, material,
                    left_out);
        scene.materials.push_back(std::move(material));
    }
    if (scene.materials.empty()) scene.materials.emplace_back();
}

}  // namespace crevice
