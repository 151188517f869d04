// SPDX-License-Identifier: MIT
// What every device can do, and what none can.
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

Status checkReadable(const Device& device, TextureId id)
{
    const ObjectInfo info = device.info(id);
    if (info.exists && info.samples == 1) return {};
    const std::string name = "texture " + std::to_string(id.value);
    if (!info.exists)
        return Diagnostic{Code::bad_input, name + " is none of this device",
                          "take an id that this device gave and that is not destroyed yet"};
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
    const auto count = static_cast<std::uint32_t>(components);
    switch (type) {
    case VertexType::float32: return 4 * count;
    case VertexType::float16:
    case VertexType::snorm16:
    case VertexType::unorm16: return 2 * count;
    case VertexType::snorm8:
    case VertexType::unorm8: return count;
    case VertexType::snorm10: break;
    }
    return 4;
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

}  // namespace crevice
