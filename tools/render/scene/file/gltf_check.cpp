// SPDX-License-Identifier: MIT
// Versions and extensions of glTF, by what Assimp 5.2 and the import of materials read.
#include "tools/render/scene/file/gltf_check.h"

#include "core/base/files.h"
#include "core/base/text.h"
#include "tools/commands/cli/output.h"
#include "tools/render/scene/file/limits.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <set>

namespace crevice {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126;  // GL_FLOAT, a componentType

enum class Support {
    read,    // drawn as the file says
    elided,  // the surfaces are right without it, though not their look: required or not, a warning
    missing,  // wrong surfaces or textures: an error where it is required
};

struct Extension {
    const char* name;  // all that begin so, with a '*' at its end
    Support support;
    const char* way_out;
};

constexpr const char* kToPng = "convert the textures: 'gltf-transform png in.glb out.glb'";

// Whatever is not here is missing. Assimp 5.2 knows more names than it reads, and looks at none
// that is required.
constexpr Extension kExtensions[] = {
    {"EXT_meshopt_compression", Support::missing, "compress with 'gltfpack -noq' and no -c"},
    {"EXT_texture_avif", Support::missing, kToPng},
    {"EXT_texture_webp", Support::missing, kToPng},
    {"KHR_animation_pointer", Support::elided, ""},
    {"KHR_draco_mesh_compression", Support::read, ""},
    {"KHR_lights_punctual", Support::read, ""},
    {"KHR_materials_*", Support::elided, ""},
    {"KHR_mesh_quantization", Support::missing,
     "write floats: 'gltfpack -noq', or 'gltf-transform dequantize in.glb out.glb'"},
    {"KHR_texture_basisu", Support::missing,
     "convert the textures: 'gltf-transform ktxdecompress in.glb out.glb'"},
    {"KHR_texture_transform", Support::elided, ""},
    {"KHR_xmp*", Support::elided, ""},
    {"MSFT_texture_dds", Support::missing, "convert the textures to PNG"},
};

constexpr Extension kUnheardOf = {"", Support::missing, "export the scene without it"};

const Extension& extensionNamed(const std::string& name)
{
    const auto matches = [&](const Extension& each) {
        const std::string_view pattern = each.name;
        return pattern.back() == '*' ? startsWith(name, pattern.substr(0, pattern.size() - 1))
                                     : name == pattern;
    };
    const auto found = std::find_if(std::begin(kExtensions), std::end(kExtensions), matches);
    return found == std::end(kExtensions) ? kUnheardOf : *found;
}

std::uint64_t littleEndian(std::string_view bytes)
{
    std::uint64_t value = 0;
    for (int k = 3; k >= 0; --k) value = value << 8 | static_cast<unsigned char>(bytes[k]);
    return value;
}

// The JSON chunk of a .glb file, or the whole of a .gltf file. Errors: CV7002 for a chunk that is
// longer than the file.
Result<std::string> jsonText(const std::string& path, std::uint64_t size)
{
    constexpr std::size_t kHead = 20, kNext = 8;  // of the file and its first chunk; of another
    const std::string head = readStart(path, kHead).bytes;
    if (head.size() < kHead || !startsWith(head, "glTF"))
        return readStart(path, std::numeric_limits<std::uint32_t>::max()).bytes;
    std::uint64_t length = littleEndian(head.substr(12)), end = kHead + length;
    std::string text;
    if (end <= size) {
        text = readStart(path, end + kNext).bytes.substr(kHead);
        if (text.size() == length + kNext) end += kNext + littleEndian(text.substr(length));
    }
    if (end > size) {
        const auto limit = static_cast<double>(size);
        return overLimit(path, "bytes in its chunks", static_cast<double>(end), limit, size);
    }
    text.resize(length);
    return text;
}

const json kNull;

// The member of that name; null where there is none, or nothing has members.
const json& member(const json& object, const char* name)
{
    if (!object.is_object()) return kNull;
    const auto found = object.find(name);
    return found == object.end() ? kNull : *found;
}

// The entry of a list; null where there is none.
const json& entryOf(const json& list, const json& index)
{
    if (!list.is_array() || !index.is_number_unsigned()) return kNull;
    const auto at = index.get<std::size_t>();
    return at < list.size() ? list[at] : kNull;
}

std::set<std::string> names(const json& list)
{
    std::set<std::string> all;
    if (list.is_array())
        for (const json& entry : list)
            if (entry.is_string()) all.insert(entry.get<std::string>());
    return all;
}

// Whether some primitive takes an attribute whose name begins so from numbers that are not floats,
// which Assimp copies as if they were.
bool takesIntegers(const json& gltf, std::string_view attribute)
{
    const json& accessors = member(gltf, "accessors");
    const auto not_float = [&](const json& index) {
        const json& type = member(entryOf(accessors, index), "componentType");
        return type.is_number() && type != kFloat;
    };
    for (const json& mesh : member(gltf, "meshes"))
        for (const json& primitive : member(mesh, "primitives"))
            for (const auto& [name, index] : member(primitive, "attributes").items())
                if (startsWith(name, attribute) && not_float(index)) return true;
    return false;
}

// Whether some material takes a texture at the second set of coordinates: all are drawn at the
// first.
bool takesSecondCoordinates(const json& gltf)
{
    const auto second = [](const json& texture) {
        const json& set = member(texture, "texCoord");
        return set.is_number() && set != 0;
    };
    for (const json& material : member(gltf, "materials"))
        if (second(member(member(material, "pbrMetallicRoughness"), "baseColorTexture")) ||
            second(member(material, "normalTexture")) ||
            second(member(material, "occlusionTexture")))
            return true;
    return false;
}

// Nodes, and primitives at them, as often as paths lead there.
struct Placements {
    static constexpr int kDeepest = 1000;  // Assimp goes down by recursion

    const json& nodes;
    const json& meshes;
    bool too_deep = false;
    std::map<const json*, double> all_below = {};  // the node itself included

    /// Below a list of nodes. What leads back to itself counts once; Assimp refuses it.
    double of(const json& list, int depth = 0)
    {
        double sum = 0;
        too_deep = too_deep || depth > kDeepest;
        if (!list.is_array() || too_deep) return sum;
        for (const json& index : list) {
            const json& node = entryOf(nodes, index);
            const auto [below, added] = all_below.try_emplace(&node, 0.0);
            if (added && !node.is_null()) {
                const json& mesh = entryOf(meshes, member(node, "mesh"));
                below->second = 1 + static_cast<double>(member(mesh, "primitives").size()) +
                                of(member(node, "children"), depth + 1);
            }
            sum += below->second;
        }
        return sum;
    }
};

// Of the file and its buffers; what is not found has the bytes that it says.
double bytesOf(const json& gltf, const std::string& path, std::uint64_t size)
{
    auto bytes = static_cast<double>(size);
    for (const json& buffer : member(gltf, "buffers")) {
        const json &uri = member(buffer, "uri"), &length = member(buffer, "byteLength");
        if (!uri.is_string() || startsWith(uri.get<std::string>(), "data:")) continue;
        std::error_code error;
        const auto file = std::filesystem::path(path).parent_path() / uri.get<std::string>();
        const std::uintmax_t found = std::filesystem::file_size(file, error);
        if (!error) bytes += static_cast<double>(found);
        if (error && length.is_number()) bytes += length.get<double>();
    }
    return bytes;
}

// What the file would unfold to, before Assimp does.
Status checkClaims(const json& gltf, const std::string& path, double bytes)
{
    const auto size = static_cast<std::uint64_t>(std::min(bytes, 1e18));
    for (const json& accessor : member(gltf, "accessors")) {
        const json& count = member(accessor, "count");
        if (count.is_number() && count.get<double>() > bytes)
            return overLimit(path, "elements in an accessor", count.get<double>(), bytes, size);
    }
    Placements placements = {member(gltf, "nodes"), member(gltf, "meshes")};
    double nodes = 0;
    for (const json& scene : member(gltf, "scenes")) nodes += placements.of(member(scene, "nodes"));
    const double limit = sceneLimits(size).nodes;
    if (nodes > limit) return overLimit(path, "nodes and meshes at them", nodes, limit, size);
    if (placements.too_deep)
        return overLimit(path, "nodes or more one below another", Placements::kDeepest + 1,
                         Placements::kDeepest, size);
    return {};
}

Status required(const std::string& path, const std::set<std::string>& extensions)
{
    std::vector<std::string> missing, ways_out;
    for (const std::string& name : extensions) {
        const Extension& extension = extensionNamed(name);
        if (extension.support != Support::missing) continue;
        missing.push_back(name);
        if (std::find(ways_out.begin(), ways_out.end(), extension.way_out) == ways_out.end())
            ways_out.push_back(extension.way_out);
    }
    if (missing.empty()) return {};
    return Diagnostic{Code::scene_broken,
                      "the scene '" + path + "' needs " + joined(missing, " and ") +
                          (missing.size() == 1 ? ", which is not read" : ", which are not read"),
                      joined(ways_out, "; ")};
}

}  // namespace

Status checkGltf(const std::string& path, bool any_version)
{
    std::error_code unknown;
    const std::uint64_t size = std::filesystem::file_size(path, unknown);
    const Result<std::string> text = jsonText(path, size);
    if (!text) return text.diagnostics();
    const json gltf = json::parse(*text, nullptr, false);
    if (!gltf.is_object()) return {};
    const Status fits = checkClaims(gltf, path, bytesOf(gltf, path, size));
    if (!fits) return fits;
    const json& version = member(member(gltf, "asset"), "version");
    if (!any_version && version.is_string() && !startsWith(version.get<std::string>(), "2.")) {
        return Diagnostic{
            Code::scene_broken,
            "the scene '" + path + "' is of glTF " + version.get<std::string>() + ", not 2.0",
            "convert it to glTF 2.0, or try --any-format"};
    }
    std::set<std::string> needed = names(member(gltf, "extensionsRequired"));
    if (takesIntegers(gltf, "POSITION") || takesIntegers(gltf, "NORMAL"))
        needed.insert("KHR_mesh_quantization");
    if (Status status = required(path, needed); !status) return status;

    std::set<std::string> used = names(member(gltf, "extensionsUsed"));
    used.insert(needed.begin(), needed.end());
    std::vector<std::string> elided;
    for (const std::string& name : used)
        if (extensionNamed(name).support != Support::read) elided.push_back(name);
    if (takesIntegers(gltf, "TEXCOORD"))
        elided.push_back("texture coordinates that are not floats");
    if (takesSecondCoordinates(gltf)) elided.push_back("the second set of texture coordinates");
    if (elided.empty()) return {};
    return asWarning(
        {Code::scene_features, "the scene '" + path + "' is drawn without " + joined(elided),
         "ambient occlusion needs none of it where surfaces and holes in them are right; compare "
         "the picture with another viewer's"});
}

}  // namespace crevice
