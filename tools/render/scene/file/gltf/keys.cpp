// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/gltf/file.h"

#include "core/base/text.h"
#include "tools/commands/cli/output.h"

namespace crevice {

namespace {

// An object of glTF's schema. A key may be "key>object", for what is in it or in its entries.
struct ObjectKeys {
    const char* object;
    const char* read;
    const char* harmless;
};

constexpr ObjectKeys kObjects[] = {
    {"glTF",
     "accessors>accessor animations>animation bufferViews>bufferView buffers>buffer "
     "cameras>camera extensions extensionsRequired extensionsUsed images>image "
     "materials>material meshes>mesh nodes>node samplers>sampler scene scenes>scene skins>skin "
     "textures>texture",
     "asset"},
    {"scene", "nodes", "name"},
    {"node", "camera children matrix mesh name rotation scale skin translation weights", ""},
    {"mesh", "primitives>primitive weights", "name"},
    {"primitive", "attributes>attributes indices material mode targets>attributes", ""},
    {"attributes", "POSITION NORMAL TEXCOORD_ COLOR_0 JOINTS_ WEIGHTS_", "TANGENT _ COLOR_"},
    {"accessor", "bufferView byteOffset componentType count normalized sparse>sparse type",
     "max min name"},
    {"sparse", "count indices>sparse_part values>sparse_part", ""},
    {"sparse_part", "bufferView byteOffset componentType", ""},
    {"bufferView", "buffer byteLength byteOffset byteStride", "name target"},
    {"buffer", "byteLength uri", "name"},
    {"material",
     "alphaCutoff alphaMode emissiveFactor emissiveTexture>texture_use normalTexture>texture_use "
     "occlusionTexture>texture_use pbrMetallicRoughness>base_colour",
     "doubleSided name"},
    {"base_colour",
     "baseColorFactor baseColorTexture>texture_use metallicFactor "
     "metallicRoughnessTexture>texture_use roughnessFactor",
     ""},
    {"texture_use", "index scale strength texCoord", ""},
    {"texture", "sampler source", "name"},
    {"image", "bufferView uri", "mimeType name"},
    {"sampler", "magFilter wrapS wrapT", "minFilter name"},
    {"camera", "orthographic>orthographic perspective>perspective type", "name"},
    {"orthographic", "ymag zfar znear", "xmag"},
    {"perspective", "yfov zfar znear", "aspectRatio"},
    {"skin", "inverseBindMatrices joints", "name skeleton"},
    {"animation", "channels>channel samplers>animation_sampler", "name"},
    {"channel", "sampler target>target", ""},
    {"target", "node path", ""},
    {"animation_sampler", "input interpolation output", ""},
};

// Why what is not read changes nothing, by "object.key".
constexpr std::pair<const char*, const char*> kWhyHarmless[] = {
    {"attributes.TANGENT", "follows from the texture coordinates"},
    {"attributes._", "an application's own"},
    {"attributes.COLOR_", "the second and later have no meaning of their own"},
    {"material.doubleSided", "surfaces are seen, and occlude, from both sides"},
    {"orthographic.xmag", "the picture has a shape of its own"},
    {"perspective.aspectRatio", "the picture has a shape of its own"},
    {"sampler.minFilter", "there is one level of each texture"},
    {"skin.skeleton", "where a host puts the skin's root"},
};

enum class Support { read, harmless, look, shape };

struct Extension {
    const char* name;  // all that begin so, with a '*' at its end
    Support support;
    const char* way_out = "";  // where it is required and not read
};

constexpr const char* kToPng = "convert the textures: 'gltf-transform png in.glb out.glb'";

constexpr Extension kExtensions[] = {
    {"EXT_instance_features", Support::harmless},
    {"EXT_lights_*", Support::look},
    {"EXT_mesh_features", Support::harmless},
    {"EXT_mesh_gpu_instancing", Support::read},
    {"EXT_meshopt_compression", Support::read},
    {"EXT_structural_metadata", Support::harmless},
    {"EXT_texture_avif", Support::shape, kToPng},
    {"EXT_texture_webp", Support::read},
    {"KHR_animation_pointer", Support::look},
    {"KHR_draco_mesh_compression", Support::read},
    {"KHR_lights_punctual", Support::read},
    {"KHR_materials_emissive_strength", Support::read},
    {"KHR_materials_ior", Support::read},
    {"KHR_materials_pbrSpecularGlossiness", Support::read},
    {"KHR_materials_specular", Support::read},
    {"KHR_materials_transmission", Support::read},
    {"KHR_materials_unlit", Support::read},
    {"KHR_materials_*", Support::look},
    {"KHR_mesh_quantization", Support::read},
    {"KHR_node_visibility", Support::read},
    {"KHR_texture_basisu", Support::shape,
     "convert the textures: 'gltf-transform ktxdecompress in.glb out.glb'"},
    {"KHR_texture_transform", Support::read},
    {"KHR_xmp*", Support::harmless},
    {"MSFT_texture_dds", Support::shape, "convert the textures to PNG"},
};

constexpr Extension kUnheardOf = {"", Support::shape, "export the scene without it"};

const Extension& extensionNamed(const std::string& name)
{
    for (const Extension& each : kExtensions) {
        std::string_view pattern = each.name;
        const bool open = pattern.back() == '*';
        if (open) pattern.remove_suffix(1);
        if (open ? startsWith(name, pattern) : name == pattern) return each;
    }
    return kUnheardOf;
}

// The word of the list that names `key`, whole or by an end in '_'; empty where none does.
std::string_view wordFor(std::string_view list, std::string_view key)
{
    for (std::string_view word : split(list, ' ')) {
        const std::string_view name = word.substr(0, word.find('>'));
        const bool matches =
            !name.empty() && (name == key || (name.back() == '_' && startsWith(key, name)));
        if (matches) return word;
    }
    return {};
}

struct Walk {
    LeftOut& found;

    void extensions(const json& all)
    {
        for (const auto& [name, value] : all.items()) {
            const Support support = extensionNamed(name).support;
            if (support == Support::look) found.look.insert(name);
            if (support == Support::shape) found.shape.insert(name);
        }
    }

    void object(const json& value, const std::string& name)
    {
        if (value.is_array())
            for (const json& each : value) object(each, name);
        if (!value.is_object()) return;
        const auto keys = std::find_if(std::begin(kObjects), std::end(kObjects),
                                       [&](const ObjectKeys& each) { return each.object == name; });
        for (const auto& [key, below] : value.items()) {
            if (key == "extras") continue;
            if (key == "extensions") {
                if (below.is_object()) extensions(below);
                continue;
            }
            const std::string_view word = wordFor(keys->read, key);
            const std::size_t arrow = word.find('>');
            if (arrow != word.npos) object(below, std::string(word.substr(arrow + 1)));
            if (word.empty() && wordFor(keys->harmless, key).empty())
                found.shape.insert("the unknown key '" + key + "' of " + name);
        }
    }
};

void findByValues(const json& gltf, LeftOut& found)
{
    constexpr int kTriangles = 4, kTriangleFan = 6;
    for (const json& material : member(gltf, "materials")) {
        const json& older = extensionOf(material, "KHR_materials_pbrSpecularGlossiness");
        if (!member(older, "specularGlossinessTexture").is_null())
            found.look.insert("maps of glossiness");
        const json& specular = extensionOf(material, "KHR_materials_specular");
        for (const char* key : {"specularTexture", "specularColorTexture", "specularColorFactor"})
            if (!member(specular, key).is_null()) found.look.insert(key);
    }
    for (const json& mesh : member(gltf, "meshes"))
        for (const json& primitive : member(mesh, "primitives")) {
            const double mode = numberOf(member(primitive, "mode"), kTriangles);
            if (mode < kTriangles) found.shape.insert("points and lines");
            if (mode > kTriangleFan) found.shape.insert("primitives of an unknown mode");
        }
    for (const json& light : member(extensionOf(gltf, "KHR_lights_punctual"), "lights"))
        if (!member(light, "range").is_null()) found.look.insert("ranges of lights");
}

std::vector<std::string> names(const json& list)
{
    std::set<std::string> all;
    if (list.is_array())
        for (const json& entry : list)
            if (entry.is_string()) all.insert(entry.get<std::string>());
    return {all.begin(), all.end()};
}

std::string cell(std::string_view words)
{
    std::vector<std::string> keys;
    for (const std::string_view word : split(words, ' '))
        if (!word.empty()) keys.push_back("`" + std::string(word.substr(0, word.find('>'))) + "`");
    return joined(keys);
}

}  // namespace

LeftOut leftOutOf(const json& gltf)
{
    LeftOut found;
    Walk{found}.object(gltf, "glTF");
    findByValues(gltf, found);
    return found;
}

Status checkRequired(const json& gltf, const std::string& path)
{
    const json& version = member(member(gltf, "asset"), "version");
    const std::string said = version.is_string() ? version.get<std::string>() : version.dump();
    if (!version.is_null() && !startsWith(said, "2."))
        throw BrokenGltf("it is of glTF " + said + ", not 2.0");
    std::vector<std::string> missing;
    std::set<std::string> ways_out;
    for (const std::string& name : names(member(gltf, "extensionsRequired"))) {
        const Extension& extension = extensionNamed(name);
        if (extension.support != Support::shape) continue;
        missing.push_back(name);
        ways_out.insert(extension.way_out);
    }
    if (missing.empty()) return {};
    return Diagnostic{Code::scene_broken,
                      "the scene '" + path + "' needs " + joined(missing, " and ") +
                          (missing.size() == 1 ? ", which is not read" : ", which are not read"),
                      joined({ways_out.begin(), ways_out.end()}, "; ")};
}

std::string gltfTables()
{
    std::string text = "| object | read | changes nothing |\n|---|---|---|\n";
    for (const auto& [object, read, harmless] : kObjects)
        text += "| " + std::string(object) + " | " + cell(read) + " | " + cell(harmless) + " |\n";
    text += "\n| key | why it changes nothing |\n|---|---|\n";
    for (const auto& [key, why] : kWhyHarmless)
        text += "| `" + std::string(key) + "` | " + why + " |\n";
    constexpr const char* kSupport[] = {"read", "changes nothing", "named: colours",
                                        "named; an error where it is required"};
    text += "\n| extension | |\n|---|---|\n";
    for (const Extension& each : kExtensions)
        text += "| `" + std::string(each.name) + "` | " + kSupport[int(each.support)] + " |\n";
    return text;
}

}  // namespace crevice
