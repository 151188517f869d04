// SPDX-License-Identifier: MIT
// What every device can do, and what none can.
#include <crevice/device.h>

#include <algorithm>

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
