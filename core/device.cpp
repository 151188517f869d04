// SPDX-License-Identifier: MIT
// What every device can do, and what none can.
#include "core/device.h"

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

Status checkMeshSize(const std::string& label, std::uint64_t vertices, std::uint64_t indices)
{
    constexpr std::uint64_t kVertices = kMaxMeshBytes / sizeof(Vertex);
    constexpr std::uint64_t kIndices = kMaxMeshBytes / sizeof(std::uint32_t);
    if (vertices <= kVertices && indices <= kIndices) return {};
    Diagnostic error{Code::too_big_for_device,
                     "mesh '" + label + "' has " + std::to_string(vertices) + " vertices and " +
                         std::to_string(indices) + " indices; one mesh holds " +
                         std::to_string(kVertices) + " and " + std::to_string(kIndices)};
    error.help = "split the mesh";
    return error;
}

Status checkMesh(const MeshDesc& mesh)
{
    if (Status size = checkMeshSize(mesh.label, mesh.vertices.size(), mesh.indices.size()); !size)
        return size;
    const auto last = std::max_element(mesh.indices.begin(), mesh.indices.end());
    if (last == mesh.indices.end() || *last < mesh.vertices.size()) return {};
    Diagnostic error{Code::bad_input,
                     "mesh '" + mesh.label + "' has " + std::to_string(mesh.vertices.size()) +
                         " vertices, and index " + std::to_string(last - mesh.indices.begin()) +
                         " names vertex " + std::to_string(*last)};
    error.help = "vertices count from 0";
    return error;
}

}  // namespace crevice
