// SPDX-License-Identifier: MIT
// Meshes: copied from arrays, and in buffers of the host's.
#include "effects/api/c/handles.h"

#include <algorithm>
#include <numeric>

using namespace crevice;

namespace {

static_assert(static_cast<int>(VertexType::snorm10) == CREVICE_SNORM10 &&
                  static_cast<int>(IndexType::uint8) == CREVICE_UINT8,
              "crevice_vertex_type and crevice_index_type are VertexType and IndexType");

std::string labelOf(const char* label) { return label ? label : "mesh"; }

/// Errors: CV6011, CV6007.
Status checkArrays(const crevice_mesh_desc& desc)
{
    if (Status given = checkGiven(desc.positions, "the array of positions"); !given) return given;
    if (desc.vertex_count == 0) return Diagnostic{Code::bad_input, "vertex_count is 0"};
    if (!desc.indices && desc.index_count > 0)
        return Diagnostic{Code::bad_input, "index_count is " + std::to_string(desc.index_count) +
                                               ", and the array of indices is null"};
    return checkMeshSize(labelOf(desc.label), desc.vertex_count,
                         std::max(desc.vertex_count, desc.index_count));
}

/// Errors: CV6011 for an unknown type.
Status checkTypes(const crevice_host_mesh& mesh)
{
    const auto known = [](const crevice_attribute& attribute) {
        return checkEnum(attribute.type, CREVICE_SNORM10, "crevice_vertex_type");
    };
    return firstOf(known(mesh.position), known(mesh.normal), known(mesh.uv),
                   checkEnum(mesh.index_type, CREVICE_UINT8, "crevice_index_type"));
}

HostAttribute attributeOf(const crevice_attribute& from)
{
    return {from.buffer, static_cast<VertexType>(from.type), from.offset, from.stride};
}

Result<MeshId> makeMesh(Device& device, const crevice_mesh_desc& desc)
{
    if (Status status = checkArrays(desc); !status) return status.diagnostics();
    return device.createMesh(meshOf(desc));
}

Result<MeshId> makeMesh(Device& device, const crevice_host_mesh& host)
{
    if (Status status = checkTypes(host); !status) return status.diagnostics();
    return device.adoptMesh(meshOf(host));
}

template <class Struct>
crevice_error* make(crevice_device* device, const Struct* desc, const char* name,
                    crevice_mesh** mesh) noexcept
{
    if (mesh) *mesh = nullptr;
    return guarded([&]() -> Status {
        Struct own = {};
        const Status given = firstOf(checkGiven(device, "the device"), take(desc, name, own),
                                     checkGiven(mesh, "the place for the mesh"));
        if (!given) return given;
        Result<MeshId> made = makeMesh(*device->device, own);
        if (!made) return made.diagnostics();
        Owned<MeshId> id(*device->device, *made);
        auto shared = std::make_shared<SharedMesh>(SharedMesh{device->device, std::move(id)});
        *mesh = new crevice_mesh{std::move(shared)};
        return {};
    });
}

}  // namespace

MeshDesc crevice::meshOf(const crevice_mesh_desc& desc)
{
    MeshDesc mesh{labelOf(desc.label), std::vector<Vertex>(desc.vertex_count), {}};
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        std::copy_n(desc.positions + 3 * i, 3, vertex.position);
        if (desc.normals) std::copy_n(desc.normals + 3 * i, 3, vertex.normal);
        if (desc.uvs) std::copy_n(desc.uvs + 2 * i, 2, vertex.uv);
    }
    mesh.indices.resize(desc.indices ? desc.index_count : desc.vertex_count);
    if (desc.indices)
        std::copy_n(desc.indices, desc.index_count, mesh.indices.begin());
    else
        std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    return mesh;
}

HostMesh crevice::meshOf(const crevice_host_mesh& from)
{
    HostMesh mesh;
    mesh.label = labelOf(from.label);
    mesh.position = attributeOf(from.position);
    mesh.normal = attributeOf(from.normal);
    mesh.uv = attributeOf(from.uv);
    mesh.vertex_count = from.vertex_count;
    mesh.index_buffer = from.index_buffer;
    mesh.index_type = static_cast<IndexType>(from.index_type);
    mesh.index_offset = from.index_offset;
    const bool all = from.index_buffer == 0 && from.index_count == 0;
    mesh.index_count = all ? from.vertex_count : from.index_count;
    return mesh;
}

crevice_error* crevice_mesh_create(crevice_device* device, const crevice_mesh_desc* desc,
                                   crevice_mesh** mesh)
{
    return make(device, desc, "crevice_mesh_desc", mesh);
}

crevice_error* crevice_mesh_adopt(crevice_device* device, const crevice_host_mesh* host,
                                  crevice_mesh** mesh)
{
    return make(device, host, "crevice_host_mesh", mesh);
}

void crevice_mesh_destroy(crevice_mesh* mesh) { delete mesh; }
