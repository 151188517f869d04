// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/gltf/file.h"

#include "tools/render/scene/mesh_normals.h"

#include <draco/compression/decode.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <memory>

namespace crevice {

namespace {

constexpr const char* kDraco = "KHR_draco_mesh_compression";

std::unique_ptr<draco::Mesh> unfolded(const GltfFile& file, const json& packed)
{
    const std::string_view bytes = file.view(indexOf(member(packed, "bufferView")));
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok())
        throw BrokenGltf("Draco cannot unfold a primitive: " + mesh.status().error_msg_string());
    return std::move(mesh).value();
}

// Where the numbers of a primitive come from.
struct Primitive {
    const GltfFile& file;
    const tinygltf::Primitive& from;
    const json& packed;
    std::unique_ptr<draco::Mesh> draco = {};

    Primitive(const GltfFile& file_, const tinygltf::Primitive& from_, const json& document)
        : file(file_),
          from(from_),
          packed(extensionOf(document, kDraco))
    {
        if (!packed.is_null()) draco = unfolded(file, packed);
    }

    // Of each vertex; empty where the primitive has none of that name.
    std::vector<float> numbers(const std::string& name, int components) const
    {
        const auto found = from.attributes.find(name);
        const int id = indexOf(member(member(packed, "attributes"), name));
        if (draco && id >= 0) {
            const draco::PointAttribute* const values =
                draco->GetAttributeByUniqueId(std::uint32_t(id));
            if (!values) throw BrokenGltf("Draco has no attribute for " + name);
            const bool scaled = found != from.attributes.end() && !values->normalized() &&
                                file.accessor(found->second).normalized;
            return numbers(*values, components,
                           scaled ? largestOf(file.accessor(found->second).componentType) : 1);
        }
        if (found == from.attributes.end()) return {};
        return file.numbers(found->second, components);
    }

    std::vector<float> numbers(const draco::PointAttribute& values, int components,
                               double largest) const
    {
        const auto width = static_cast<std::size_t>(components);
        std::vector<float> all(draco->num_points() * width, 0.0f);
        std::vector<float> row(std::max<std::size_t>(width, std::size_t(values.num_components())),
                               1.0f);
        for (std::uint32_t k = 0; k < draco->num_points(); ++k) {
            values.ConvertValue(values.mapped_index(draco::PointIndex(k)),
                                static_cast<std::int8_t>(row.size()), row.data());
            for (std::size_t c = 0; c < width; ++c)
                all[k * width + c] = int(c) < values.num_components() ? row[c] / float(largest)
                                     : c == 3                         ? 1.0f
                                                                      : 0.0f;
        }
        return all;
    }

    std::vector<std::uint32_t> indices(std::size_t vertices) const
    {
        std::vector<std::uint32_t> all;
        if (draco) {
            for (std::uint32_t k = 0; k < draco->num_faces(); ++k)
                for (const draco::PointIndex& corner : draco->face(draco::FaceIndex(k)))
                    all.push_back(corner.value());
        } else if (from.indices >= 0) {
            all = file.indices(from.indices);
        } else {
            for (std::uint32_t k = 0; k < vertices; ++k) all.push_back(k);
        }
        return all;
    }
};

// Three corners for each, whatever the mode.
std::vector<std::uint32_t> triangles(std::vector<std::uint32_t> in, int mode)
{
    if (mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) return in;
    std::vector<std::uint32_t> out;
    for (std::size_t k = 2; k < in.size(); ++k) {
        const bool odd = k % 2 == 1, fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const std::uint32_t first = fan ? in[0] : in[odd ? k - 1 : k - 2];
        const std::uint32_t second = fan ? in[k - 1] : in[odd ? k - 2 : k - 1];
        out.insert(out.end(), {first, second, in[k]});
    }
    return out;
}

void addTargets(const Primitive& primitive, const char* name, const std::vector<double>& weights,
                std::vector<float>& values)
{
    const auto& targets = primitive.from.targets;
    for (std::size_t k = 0; k < std::min(targets.size(), weights.size()); ++k) {
        const auto found = targets[k].find(name);
        if (found == targets[k].end() || weights[k] == 0) continue;
        const std::vector<float> moved = primitive.file.numbers(found->second, 3);
        for (std::size_t i = 0; i < std::min(values.size(), moved.size()); ++i)
            values[i] += static_cast<float>(weights[k]) * moved[i];
    }
}

void bendBySkin(const Primitive& primitive, const std::vector<glm::dmat4>& joints,
                std::vector<float>& positions, std::vector<float>& normals)
{
    const std::size_t count = positions.size() / 3;
    std::vector<glm::dmat4> sums(count, glm::dmat4(0.0));
    std::vector<double> shares(count, 0.0);
    for (int set = 0;; ++set) {
        const std::string number = std::to_string(set);
        const std::vector<float> names = primitive.numbers("JOINTS_" + number, 4);
        const std::vector<float> weights = primitive.numbers("WEIGHTS_" + number, 4);
        if (names.empty() || weights.empty()) break;
        for (std::size_t k = 0; k < std::min({names.size(), weights.size(), 4 * count}); ++k) {
            const auto joint = static_cast<std::size_t>(std::max(names[k], 0.0f));
            if (weights[k] == 0 || joint >= joints.size()) continue;
            sums[k / 4] += joints[joint] * double{weights[k]};
            shares[k / 4] += weights[k];
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        const glm::dmat4 bend = shares[k] > 0 ? sums[k] / shares[k] : joints[0];
        const glm::vec3 place = bend * glm::dvec4(glm::make_vec3(&positions[3 * k]), 1.0);
        std::copy_n(glm::value_ptr(place), 3, &positions[3 * k]);
        if (normals.size() < 3 * (k + 1)) continue;
        const glm::vec3 normal =
            glm::inverseTranspose(glm::dmat3(bend)) * glm::dvec3(glm::make_vec3(&normals[3 * k]));
        std::copy_n(glm::value_ptr(normal), 3, &normals[3 * k]);
    }
}

// Texture coordinates from the lower left.
void setCoordinates(const Primitive& primitive, const Coordinates& at, MeshDesc& mesh)
{
    const std::vector<float> uv = primitive.numbers("TEXCOORD_" + std::to_string(at.set), 2);
    for (std::size_t k = 0; k < std::min(uv.size() / 2, mesh.vertices.size()); ++k) {
        const glm::vec2 moved = at(glm::dvec2(uv[2 * k], uv[2 * k + 1]));
        if (!(std::abs(moved.x) <= kMaxCoordinate && std::abs(moved.y) <= kMaxCoordinate)) continue;
        mesh.vertices[k].uv[0] = moved.x + 0.0f;
        mesh.vertices[k].uv[1] = 1.0f - moved.y;
    }
}

bool usable(const MeshDesc& mesh, std::uint32_t index)
{
    if (index >= mesh.vertices.size()) return false;
    const float* const at = mesh.vertices[index].position;
    return std::all_of(at, at + 3, [](float each) { return std::abs(each) <= kMaxCoordinate; });
}

}  // namespace

std::optional<GltfMesh> gltfMesh(const GltfFile& file, int mesh_index, int primitive_index,
                                 const Bending& bending, GltfMaterials& materials)
{
    const tinygltf::Mesh& owner = file.model().meshes[std::size_t(mesh_index)];
    const tinygltf::Primitive& from = owner.primitives[std::size_t(primitive_index)];
    if (from.mode >= 0 && from.mode < TINYGLTF_MODE_TRIANGLES) return std::nullopt;
    const json& document = entryOf(file.list("meshes"), mesh_index);
    const Primitive primitive(file, from, entryOf(member(document, "primitives"), primitive_index));
    std::vector<float> positions = primitive.numbers("POSITION", 3);
    std::vector<float> normals = primitive.numbers("NORMAL", 3);
    addTargets(primitive, "POSITION", bending.weights, positions);
    addTargets(primitive, "NORMAL", bending.weights, normals);
    if (!bending.joints.empty()) bendBySkin(primitive, bending.joints, positions, normals);

    GltfMesh made;
    MeshDesc& mesh = made.mesh;
    mesh.label = owner.name;
    mesh.vertices.resize(positions.size() / 3);
    for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
        setVertex(mesh.vertices[k], &positions[3 * k],
                  normals.size() >= 3 * (k + 1) ? &normals[3 * k] : nullptr);
    setCoordinates(primitive, materials.coordinates(from.material).value_or(Coordinates()), mesh);
    const bool has_normals = !normals.empty();
    for (std::vector<float>* done : {&positions, &normals}) std::vector<float>().swap(*done);
    const auto all = triangles(primitive.indices(mesh.vertices.size()), from.mode);
    mesh.indices.reserve(all.size());
    for (std::size_t k = 0; k + 2 < all.size(); k += 3) {
        const bool whole = std::all_of(&all[k], &all[k] + 3,
                                       [&](std::uint32_t corner) { return usable(mesh, corner); });
        if (whole) mesh.indices.insert(mesh.indices.end(), &all[k], &all[k] + 3);
        made.dropped += !whole;
    }
    std::vector<float> colors = primitive.numbers("COLOR_0", 4);
    colors.resize(colors.empty() || mesh.indices.empty() ? 0 : 4 * mesh.vertices.size(), 1.0f);
    made.material = materials.materialFor(from.material, std::move(colors), mesh);
    made.turned = finishMesh(mesh, has_normals, kGltfCreaseDegrees);
    return made;
}

}  // namespace crevice
