// SPDX-License-Identifier: MIT
// Texture formats; what every device can do, and what none can.
#include <crevice/device.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

DeviceCaps minimumCaps()
{
    DeviceCaps caps;
    caps.name = "minimum of OpenGL ES 3.0";
    for (const FormatInfo& info : allFormats()) {
        if (!info.core_renderable) continue;
        caps.renderable[static_cast<int>(info.format)] = true;
        caps.sample_counts[static_cast<int>(info.format)] = 1u << 3;  // GL_MAX_SAMPLES is 4 or more
    }
    return caps;
}

int layerOf(const std::vector<TextureId>& color, int place)
{
    const auto same = [&](TextureId id) { return id.value == color[place].value; };
    return static_cast<int>(std::count_if(color.begin(), color.begin() + place, same));
}

Status checkReadable(const Device& device, TextureId id)
{
    const ObjectInfo info = device.info(id);
    if (info.exists && info.samples == 1 && info.depth == 0) return {};
    const std::string name = "texture " + std::to_string(id.value);
    if (!info.exists)
        return Diagnostic{Code::bad_input, name + " is none of this device",
                          "take an id that this device gave and that is not destroyed yet"};
    if (info.depth > 0)
        return Diagnostic{Code::bad_input, name + " is a volume, and only a picture can be read",
                          "draw a layer of it into a picture"};
    return Diagnostic{Code::bad_input,
                      name + " has " + std::to_string(info.samples) +
                          " samples a pixel, and only one can be read or written",
                      "resolve it to a texture of one sample"};
}

Status checkMeshSize(const std::string& label, std::uint64_t vertices, std::uint64_t indices)
{
    constexpr std::uint64_t kVertices = kMaxMeshBytes / sizeof(Vertex);
    constexpr std::uint64_t kIndices = kMaxMeshBytes / sizeof(std::uint32_t);
    if (vertices <= kVertices && indices <= kIndices) return {};
    return Diagnostic{Code::too_big_for_device,
                      "mesh '" + label + "' has " + std::to_string(vertices) + " vertices and " +
                          std::to_string(indices) + " indices; one mesh holds " +
                          std::to_string(kVertices) + " and " + std::to_string(kIndices),
                      "split the mesh"};
}

std::uint32_t bytesOf(VertexType type, int components)
{
    constexpr std::uint32_t kBytes[] = {4, 2, 1, 1, 2, 2};  // in the order of VertexType
    if (type == VertexType::snorm10) return 4;              // all in one word
    return kBytes[static_cast<int>(type)] * static_cast<std::uint32_t>(components);
}

std::uint32_t bytesOf(IndexType type)
{
    return type == IndexType::uint32 ? 4 : type == IndexType::uint16 ? 2 : 1;
}

Status checkMesh(const HostMesh& mesh)
{
    const auto bad = [&mesh](const std::string& what, const char* help) -> Status {
        return Diagnostic{Code::bad_input, "mesh '" + mesh.label + "' " + what, help};
    };
    if (mesh.position.buffer == 0 || mesh.vertex_count == 0)
        return bad("has no positions", "set HostMesh::position and vertex_count");
    if (mesh.index_buffer != 0 && mesh.index_offset % bytesOf(mesh.index_type) != 0)
        return bad("has its first index at byte " + std::to_string(mesh.index_offset) +
                       ", and one takes " + std::to_string(bytesOf(mesh.index_type)) + " bytes",
                   "begin at a multiple of that");
    if (mesh.index_buffer == 0 && mesh.index_count > mesh.vertex_count)
        return bad("has " + std::to_string(mesh.vertex_count) + " vertices and draws " +
                       std::to_string(mesh.index_count),
                   "without indices, index_count counts vertices");
    return {};
}

MeshOrigin originOf(const MeshDesc& mesh)
{
    if (mesh.vertices.empty()) return {};
    const float* const first = mesh.vertices.front().position;
    glm::dvec3 low(first[0], first[1], first[2]), high = low;
    for (const Vertex& vertex : mesh.vertices) {
        const glm::dvec3 at(vertex.position[0], vertex.position[1], vertex.position[2]);
        if (!std::isfinite(at.x + at.y + at.z)) return {};
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const glm::dvec3 middle = (low + high) / 2.0, size = high - low;
    if (glm::dot(middle, middle) <= glm::dot(size, size)) return {};
    return {middle.x, middle.y, middle.z};
}

Status checkMesh(const MeshDesc& mesh)
{
    if (Status size = checkMeshSize(mesh.label, mesh.vertices.size(), mesh.indices.size()); !size)
        return size;
    const auto last = std::max_element(mesh.indices.begin(), mesh.indices.end());
    if (last == mesh.indices.end() || *last < mesh.vertices.size()) return {};
    return Diagnostic{Code::bad_input,
                      "mesh '" + mesh.label + "' has " + std::to_string(mesh.vertices.size()) +
                          " vertices, and index " + std::to_string(last - mesh.indices.begin()) +
                          " names vertex " + std::to_string(*last),
                      "vertices count from 0"};
}

const std::vector<FormatInfo>& allFormats()
{
    constexpr double kHalf = 1.0 / (1 << 10);  // steps of numbers with 11 and 24 binary digits
    constexpr double kFloat = 1.0 / (1 << 23);
    constexpr double kHalfLeast = kHalf / (1 << 14);
    // What needs an extension: OpenGL ES 3.0 lists no floating-point format as colour-renderable.
    static const std::vector<FormatInfo> formats = {
        {Format::r8, "r8", FormatClass::unorm, 1, 1, true, true, 1.0 / 255, 0},
        {Format::rg8, "rg8", FormatClass::unorm, 2, 2, true, true, 1.0 / 255, 0},
        {Format::rgb565, "rgb565", FormatClass::unorm, 3, 2, true, true, 1.0 / 31, 0},
        {Format::rgba8, "rgba8", FormatClass::unorm, 4, 4, true, true, 1.0 / 255, 0},
        {Format::rgb10_a2, "rgb10_a2", FormatClass::unorm, 4, 4, true, true, 1.0 / 1023, 0},
        {Format::r16f, "r16f", FormatClass::floating, 1, 2, false, true, kHalfLeast, kHalf},
        {Format::rg16f, "rg16f", FormatClass::floating, 2, 4, false, true, kHalfLeast, kHalf},
        {Format::rgba16f, "rgba16f", FormatClass::floating, 4, 8, false, true, kHalfLeast, kHalf},
        {Format::r32f, "r32f", FormatClass::floating, 1, 4, false, false, 0, kFloat},
        {Format::rg32f, "rg32f", FormatClass::floating, 2, 8, false, false, 0, kFloat},
        {Format::rgba32f, "rgba32f", FormatClass::floating, 4, 16, false, false, 0, kFloat},
        {Format::r11g11b10f, "r11g11b10f", FormatClass::floating, 3, 4, false, true, 0, 1.0 / 32},
        {Format::depth16, "depth16", FormatClass::depth, 1, 2, true, false, 1.0 / 0xffff, 0},
        {Format::depth24, "depth24", FormatClass::depth, 1, 4, true, false, 1.0 / 0xffffff, 0},
        {Format::depth32f, "depth32f", FormatClass::depth, 1, 4, true, false, 0, kFloat},
    };
    return formats;
}

const std::vector<std::string>& formatNames()
{
    static const std::vector<std::string> names = namesOf(allFormats());
    return names;
}

const FormatInfo& formatInfo(Format format)
{
    static const FormatInfo none = {
        Format::none, "none", FormatClass::none, 0, 0, false, false, 0, 0};
    for (const FormatInfo& info : allFormats())
        if (info.format == format) return info;
    return none;
}

Format formatFromName(std::string_view name)
{
    const FormatInfo* found = findNamed(allFormats(), name);
    return found ? found->format : Format::none;
}

}  // namespace crevice
