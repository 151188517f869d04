// SPDX-License-Identifier: MIT
// What every device can do, and what none can.
#include <crevice/device.h>

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
    double low[3], high[3];
    for (int i = 0; i < 3; ++i) low[i] = high[i] = mesh.vertices.front().position[i];
    for (const Vertex& vertex : mesh.vertices) {
        for (int i = 0; i < 3; ++i) {
            if (!std::isfinite(vertex.position[i])) return {};
            low[i] = std::min<double>(low[i], vertex.position[i]);
            high[i] = std::max<double>(high[i], vertex.position[i]);
        }
    }
    double away = 0, size = 0;
    for (int i = 0; i < 3; ++i) {
        away += std::pow((low[i] + high[i]) / 2, 2);
        size += std::pow(high[i] - low[i], 2);
    }
    if (away <= size) return {};
    return {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
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
