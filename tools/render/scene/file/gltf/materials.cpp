// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/gltf/file.h"

#include "core/base/text.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

// Of GL, as files name them.
constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648, kNearest = 9728;

// Texels in place of one along each axis where a file does not want them smoothed.
constexpr int kSharp = 8;

// Copies of a texture side by side that stand for its edge texels beyond it.
constexpr int kMostTiles = 16;

// Glass lets through what is behind it; below that the surface itself is what is seen.
constexpr double kLeastTransmission = 0.5;

// How much of what is behind a clear pane is seen: a rest shows where it is.
constexpr double kPane = 0.85;

const char* const kSpecularGlossiness = "KHR_materials_pbrSpecularGlossiness";

glm::vec4 colorOf(const json& list, float otherwise = 1)
{
    glm::vec4 color(otherwise);
    for (int k = 0; k < 4; ++k) color[k] = static_cast<float>(numberOf(entryOf(list, k), color[k]));
    return color;
}

glm::dvec2 pairOf(const json& list, const glm::dvec2& otherwise)
{
    return {numberOf(entryOf(list, 0), otherwise.x), numberOf(entryOf(list, 1), otherwise.y)};
}

Coordinates coordinatesOf(const json& use)
{
    Coordinates at;
    const json& moved = extensionOf(use, "KHR_texture_transform");
    const double set = numberOf(member(use, "texCoord"), 0);
    at.set = static_cast<int>(numberOf(member(moved, "texCoord"), set));
    at.offset = pairOf(member(moved, "offset"), at.offset);
    at.scale = pairOf(member(moved, "scale"), at.scale);
    at.angle_rad = numberOf(member(moved, "rotation"), 0);
    return at;
}

// A texture of a material, and what it is for.
struct TextureUse {
    int SceneMaterial::*index;
    const char* what;
    Encoding encoding;
    bool shape;  // whether occlusion is another without it
    const json* from;
};

// The colour's texture first.
std::array<TextureUse, 5> textureUses(const json& material)
{
    const json& metal = member(material, "pbrMetallicRoughness");
    const json& older = member(extensionOf(material, kSpecularGlossiness), "diffuseTexture");
    const json& color = older.is_null() ? member(metal, "baseColorTexture") : older;
    return {{{&SceneMaterial::base_color_texture, "colours", Encoding::srgb, true, &color},
             {&SceneMaterial::normal_texture, "normal maps", Encoding::linear, true,
              &member(material, "normalTexture")},
             {&SceneMaterial::occlusion_texture, "baked occlusion", Encoding::linear, false,
              &member(material, "occlusionTexture")},
             {&SceneMaterial::metallic_roughness_texture, "metalness and roughness",
              Encoding::linear, false, &member(metal, "metallicRoughnessTexture")},
             {&SceneMaterial::emission_texture, "emission", Encoding::srgb, false,
              &member(material, "emissiveTexture")}}};
}

const json& leadOf(const json& material)
{
    const auto uses = textureUses(material);
    for (const TextureUse& use : uses)
        if (use.from->is_object()) return *use.from;
    return *uses[0].from;
}

// The texel of the original that stands at `at` of one laid out from tile `first` on.
int originalTexel(int at, int size, int first, int mode)
{
    const int tile = at / size + first, within = at % size;
    if (mode == kMirror) return tile % 2 == 0 ? within : size - 1 - within;
    return tile < 0 ? 0 : tile > 0 ? size - 1 : within;
}

}  // namespace

bool Coordinates::operator==(const Coordinates& other) const
{
    return set == other.set && offset == other.offset && scale == other.scale &&
           angle_rad == other.angle_rad;
}

glm::dvec2 Coordinates::operator()(const glm::dvec2& uv) const
{
    const glm::dvec2 scaled = uv * scale;
    const double sine = std::sin(angle_rad), cosine = std::cos(angle_rad);
    return offset +
           glm::dvec2(cosine * scaled.x + sine * scaled.y, cosine * scaled.y - sine * scaled.x);
}

GltfMaterials::GltfMaterials(const GltfFile& file, SceneTextures& textures, Scene& scene,
                             LeftOut& left_out)
    : file_(file),
      textures_(textures),
      scene_(scene),
      left_out_(left_out)
{
}

std::optional<Coordinates> GltfMaterials::coordinates(int material) const
{
    const json& use = leadOf(entryOf(file_.list("materials"), material));
    return use.is_object() ? std::optional(coordinatesOf(use)) : std::nullopt;
}

int GltfMaterials::image(const json& texture, Encoding encoding)
{
    const json& webp = extensionOf(texture, "EXT_texture_webp");
    const json& index = member(webp.is_null() ? texture : webp, "source");
    const json& image = entryOf(file_.list("images"), index);
    const json& uri = member(image, "uri");
    const std::string name = std::to_string(indexOf(index));
    const int view = indexOf(member(image, "bufferView"));
    if (view >= 0) return textures_.inBytes(name, file_.view(view), encoding);
    if (!uri.is_string()) return SceneTextures::kNone;  // what its extension names
    const auto text = uri.get<std::string>();
    if (!startsWith(text, "data:")) return textures_.inFile(text, encoding);
    std::vector<unsigned char> bytes;
    std::string type;
    tinygltf::DecodeDataURI(&bytes, type, octets(text), 0, false);
    return textures_.inBytes(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                             encoding);
}

int GltfMaterials::texture(const json& use, Encoding encoding)
{
    if (!use.is_object()) return SceneTextures::kNone;
    return image(entryOf(file_.list("textures"), member(use, "index")), encoding);
}

SceneMaterial GltfMaterials::read(int index)
{
    const json& from = entryOf(file_.list("materials"), index);
    SceneMaterial to;
    const json &name = member(from, "name"), &metal = member(from, "pbrMetallicRoughness"),
               &older = extensionOf(from, kSpecularGlossiness);
    const auto factor = [](const json& object, const char* key, double otherwise) {
        return static_cast<float>(numberOf(member(object, key), otherwise));
    };
    if (name.is_string()) to.name = name.get<std::string>();
    to.base_color = colorOf(older.is_null() ? member(metal, "baseColorFactor")
                                            : member(older, "diffuseFactor"));
    to.normal_scale = factor(member(from, "normalTexture"), "scale", 1);
    const float strength = factor(member(from, "occlusionTexture"), "strength", 1);
    to.occlusion_strength = std::clamp(strength, 0.0f, 1.0f);
    to.metallic = older.is_null() ? factor(metal, "metallicFactor", 1) : 0;
    to.roughness = older.is_null() ? factor(metal, "roughnessFactor", 1)
                                   : 1 - factor(older, "glossinessFactor", 1);
    const double index_of_glass =
        numberOf(member(extensionOf(from, "KHR_materials_ior"), "ior"), 1.5);
    const double mirrors = (index_of_glass - 1) / (index_of_glass + 1);
    to.reflectance = static_cast<float>(mirrors * mirrors) *
                     factor(extensionOf(from, "KHR_materials_specular"), "specularFactor", 1);
    to.emission =
        glm::vec3(colorOf(member(from, "emissiveFactor"), 0)) *
        factor(extensionOf(from, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
    to.unlit = extensionOf(from, "KHR_materials_unlit").is_object();
    for (const TextureUse& use : textureUses(from)) {
        if (use.from->is_object() && !(coordinatesOf(*use.from) == coordinatesOf(leadOf(from))))
            (use.shape ? left_out_.shape : left_out_.look)
                .insert(std::string(use.what) + " at other coordinates than the colour's");
        else
            to.*use.index = texture(*use.from, use.encoding);
    }
    return to;
}

// Alpha as holes, or as what is seen through.
void GltfMaterials::setAlpha(int index, SceneMaterial& to) const
{
    const json& from = entryOf(file_.list("materials"), index);
    const json& mode = member(from, "alphaMode");
    const json& glass = extensionOf(from, "KHR_materials_transmission");
    if (mode == "MASK")
        to.alpha_cutoff = static_cast<float>(numberOf(member(from, "alphaCutoff"), 0.5));
    const double through = numberOf(member(glass, "transmissionFactor"), 0);
    to.blended = through >= kLeastTransmission && member(glass, "transmissionTexture").is_null();
    if (!to.blended && through > 0) left_out_.look.insert("transmission below 0.5 or by a map");
    if (to.blended) to.base_color.a *= static_cast<float>(1 - kPane * through);
    if (mode != "BLEND" || to.blended) return;
    const float alpha = to.base_color.a;
    auto [vague, least] = std::pair(0.0, 1.0f);
    if (to.base_color_texture >= 0)
        std::tie(vague, least) = alphaOf(scene_.textures[std::size_t(to.base_color_texture)].image);
    const bool cut_out = alpha >= kSolid && least < kSolid && vague < kMostVague;
    if (cut_out) to.alpha_cutoff = 0.5f;
    to.blended = !cut_out && alpha * least < kSolid;
}

// Which copies of the textures hold all of the mesh's coordinates.
GltfMaterials::Layout GltfMaterials::layoutFor(int material, const MeshDesc& mesh)
{
    const json& from = entryOf(file_.list("materials"), material);
    const auto samplerOf = [&](const json& use) -> const json& {
        const json& texture = entryOf(file_.list("textures"), member(use, "index"));
        return entryOf(file_.list("samplers"), member(texture, "sampler"));
    };
    const json& sampler = samplerOf(leadOf(from));
    const bool sharp = member(sampler, "magFilter") == kNearest;
    Layout layout;
    for (int axis = 0; axis < 2; ++axis) {
        const char* const key = axis == 0 ? "wrapS" : "wrapT";
        Tiles& tiles = layout[std::size_t(axis)];
        tiles.mode = static_cast<int>(numberOf(member(sampler, key), kRepeat));
        tiles.texels = sharp ? kSharp : 1;
        for (const TextureUse& use : textureUses(from))
            if (use.from->is_object() &&
                numberOf(member(samplerOf(*use.from), key), kRepeat) != tiles.mode)
                left_out_.shape.insert("textures of one material that wrap in different ways");
        if (tiles.mode == kMirror) tiles.count = 2;
        if (tiles.mode != kClamp) continue;
        constexpr float kHair = 1e-4f;
        float low = 0, high = 1;
        for (const Vertex& vertex : mesh.vertices) {
            low = std::min(low, vertex.uv[axis] + kHair);
            high = std::max(high, vertex.uv[axis] - kHair);
        }
        const float first = std::floor(low), count = std::ceil(high) - first;
        if (!(count <= kMostTiles)) {
            left_out_.shape.insert("textures whose edges reach far");
            continue;
        }
        tiles.first = static_cast<int>(first), tiles.count = static_cast<int>(count);
    }
    return layout;
}

Extent GltfMaterials::extentOf(const Extent& size, const Layout& layout)
{
    const auto& [across, up] = layout;
    return {size.width * across.count * across.texels, size.height * up.count * up.texels};
}

// Whether there is room for all such textures that a material may have.
bool GltfMaterials::fits(int texture, const Layout& layout) const
{
    constexpr int kLongest = 1 << 14;
    if (texture < 0) return true;
    const Extent size = scene_.textures[std::size_t(texture)].image.extent;
    const Extent whole = extentOf(size, layout);
    return whole == size || (std::max(whole.width, whole.height) <= kLongest &&
                             5.0 * whole.width * whole.height <= textures_.room());
}

int GltfMaterials::laidOut(int texture, const Layout& layout)
{
    if (texture < 0) return texture;
    std::vector<int> key = {texture};
    for (const Tiles& tiles : layout)
        key.insert(key.end(), {tiles.mode, tiles.first, tiles.count, tiles.texels});
    const auto [known, added] = laid_out_.try_emplace(key, texture);
    if (!added) return known->second;
    const SceneTexture& from = scene_.textures[std::size_t(texture)];
    const Extent size = from.image.extent, whole = extentOf(size, layout);
    if (whole == size) return texture;
    const auto& [across, up] = layout;
    Image image(whole, 4);
    for (int y = 0; y < whole.height; ++y)
        for (int x = 0; x < whole.width; ++x) {
            const int column =
                originalTexel(x / across.texels, size.width, across.first, across.mode);
            const int row = originalTexel(y / up.texels, size.height, up.first, up.mode);
            for (int channel = 0; channel < 4; ++channel)
                image.at(x, y, channel) = from.image.at(column, row, channel);
        }
    return known->second = textures_.add(from.name, std::move(image));
}

bool GltfMaterials::paint(const std::vector<float>& colors, SceneMaterial& material, MeshDesc& mesh)
{
    Image image = paintedCorners(colors, textures_.room(), mesh);
    if (image.pixels.empty()) return false;
    material.base_color_texture = textures_.add(mesh.label + " colours", std::move(image));
    return true;
}

int GltfMaterials::materialFor(int index, std::vector<float> colors, MeshDesc& mesh)
{
    const auto [known, added] = read_.try_emplace(index);
    if (added) known->second = read(index);
    SceneMaterial material = known->second;
    Layout layout = layoutFor(index, mesh);
    std::vector<float> key = {static_cast<float>(index)};
    for (const Tiles& tiles : layout)
        key.insert(key.end(), {float(tiles.mode), float(tiles.first), float(tiles.count)});
    const auto uses = textureUses(entryOf(file_.list("materials"), index));
    for (const TextureUse& use : uses)
        if (!fits(material.*use.index, layout)) {
            layout = Layout();
            left_out_.shape.insert("wrap modes and filters of large textures");
        }
    for (const TextureUse& use : uses) material.*use.index = laidOut(material.*use.index, layout);
    for (Vertex& vertex : mesh.vertices)
        for (int axis = 0; axis < 2; ++axis)
            vertex.uv[axis] = (vertex.uv[axis] - float(layout[std::size_t(axis)].first)) /
                              float(layout[std::size_t(axis)].count);

    bool painted = false;
    const bool same =
        colors.size() >= 4 && std::equal(colors.begin() + 4, colors.end(), colors.begin());
    if (same) {
        material.base_color *= glm::make_vec4(colors.data());
        key.insert(key.end(), colors.begin(), colors.begin() + 4);
    } else if (!colors.empty()) {
        painted = !coordinates(index) && paint(colors, material, mesh);
        if (!painted) left_out_.shape.insert("colours of vertices on textured surfaces");
    }
    const int next = static_cast<int>(scene_.materials.size());
    if (!painted)
        if (const auto [made, fresh] = made_.try_emplace(key, next); !fresh) return made->second;
    setAlpha(index, material);
    scene_.materials.push_back(std::move(material));
    return next;
}

}  // namespace crevice
