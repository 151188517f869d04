// SPDX-License-Identifier: MIT
// Meshes of the GL device: its own, and those that lie in buffers of the host's.
#include "backends/gl/device_class.h"
#include "backends/gl/failure.h"

#include <cstddef>
#include <vector>

namespace crevice {

namespace {

/// What every vertex reads as its normal, and behind that as its uv, where the host has none.
constexpr float kConstants[] = {0, 0, 1, 0, 0};
constexpr std::size_t kConstantUv = 3 * sizeof(float);

GLenum typeOf(VertexType type)
{
    constexpr GLenum kTypes[] = {
        GL_FLOAT,          GL_HALF_FLOAT,        GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT,
        GL_UNSIGNED_SHORT, GL_INT_2_10_10_10_REV};
    return kTypes[static_cast<int>(type)];  // in the order of VertexType
}

const void* asPointer(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

void setAttribute(const GlApi& gl, GLuint location, int components, const HostAttribute& from)
{
    // GL takes packed words as four components alone; shaders read the first ones.
    const GLint count = from.type == VertexType::snorm10 ? 4 : components;
    const bool normalised = from.type != VertexType::float32 && from.type != VertexType::float16;
    gl.BindBuffer(GL_ARRAY_BUFFER, from.buffer);
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, count, typeOf(from.type), normalised ? GL_TRUE : GL_FALSE,
                           static_cast<GLsizei>(from.stride), asPointer(from.offset));
}

/// The same number for every vertex: a divisor counts instances, and only one is drawn.
void setConstant(const GlApi& gl, GLuint location, int components, std::size_t offset)
{
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, asPointer(offset));
    gl.VertexAttribDivisor(location, 1);
}

/// Whether `bytes` of that buffer of the host's are there; leaves it bound to `target`. WebGL binds
/// indices to GL_ELEMENT_ARRAY_BUFFER alone. Errors: CV6011.
Status checkBuffer(const GlApi& gl, const HostMesh& mesh, const char* what, GLenum target,
                   GLuint buffer, std::uint64_t bytes)
{
    const std::string named =
        "mesh '" + mesh.label + "' has its " + what + " in buffer " + std::to_string(buffer);
    if (!gl.IsBuffer(buffer))
        return failure(Code::bad_input, named + ", which is none of this context",
                       "give a name of glGenBuffers that was bound once");
    GLint size = 0;
    gl.BindBuffer(target, buffer);
    gl.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
    if (bytes <= static_cast<std::uint64_t>(size)) return {};
    return failure(Code::bad_input,
                   named + ", which has " + std::to_string(size) +
                       " bytes, and the last of them "
                       "ends at " +
                       std::to_string(bytes),
                   "look at its offset, its stride, its type, vertex_count and index_count");
}

Status checkBuffer(const GlApi& gl, const HostMesh& mesh, const char* what,
                   const HostAttribute& from, int components)
{
    if (from.buffer == 0) return {};
    const std::uint64_t size = bytesOf(from.type, components);
    const std::uint64_t stride = from.stride == 0 ? size : from.stride;
    return checkBuffer(gl, mesh, what, GL_ARRAY_BUFFER, from.buffer,
                       from.offset + stride * (mesh.vertex_count - 1) + size);
}

/// Leaves the indices bound to the current vertex array.
Status checkBuffers(const GlApi& gl, const HostMesh& mesh)
{
    Status positions = checkBuffer(gl, mesh, "positions", mesh.position, 3);
    if (!positions) return positions;
    Status normals = checkBuffer(gl, mesh, "normals", mesh.normal, 3);
    if (!normals) return normals;
    Status uvs = checkBuffer(gl, mesh, "uv", mesh.uv, 2);
    if (!uvs || mesh.index_buffer == 0) return uvs;
    const std::uint64_t bytes = std::uint64_t{bytesOf(mesh.index_type)} * mesh.index_count;
    return checkBuffer(gl, mesh, "indices", GL_ELEMENT_ARRAY_BUFFER, mesh.index_buffer,
                       mesh.index_offset + bytes);
}

std::vector<Vertex> about(const MeshOrigin& origin, std::vector<Vertex> vertices)
{
    const double at[] = {origin.x, origin.y, origin.z};
    for (Vertex& vertex : vertices)
        for (int i = 0; i < 3; ++i)
            vertex.position[i] = static_cast<float>(vertex.position[i] - at[i]);
    return vertices;
}

}  // namespace

Result<MeshId> GlDevice::createMesh(const MeshDesc& desc)
{
    if (Status status = checkMesh(desc); !status) return status.diagnostics();
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    Scope scope(*this);
    MeshSlot mesh{GlVertexArray::make(gl_),
                  GlBuffer::make(gl_),
                  GlBuffer::make(gl_),
                  static_cast<std::uint32_t>(desc.indices.size()),
                  originOf(desc),
                  desc.may_have_sheets ? sheetsOf(desc) : std::vector<std::uint32_t>()};
    const bool beside = mesh.origin.x != 0 || mesh.origin.y != 0 || mesh.origin.z != 0;
    const std::vector<Vertex> moved =
        beside ? about(mesh.origin, desc.vertices) : std::vector<Vertex>();
    gl_.BindVertexArray(mesh.vertex_array.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
    gl_.BufferData(GL_ARRAY_BUFFER, desc.vertices.size() * sizeof(Vertex),
                   beside ? moved.data() : desc.vertices.data(), GL_STATIC_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.name());
    std::vector<std::uint32_t> twice;  // the indices, and those of sheets once more
    if (!mesh.sheets.empty()) {
        twice = desc.indices;
        for (const std::uint32_t first : mesh.sheets)
            twice.insert(twice.end(), &desc.indices[first], &desc.indices[first] + 3);
    }
    const std::vector<std::uint32_t>& indices = twice.empty() ? desc.indices : twice;
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof(std::uint32_t), indices.data(),
                   GL_STATIC_DRAW);
    const auto attribute = [&mesh](std::size_t offset) {
        return HostAttribute{mesh.vertices.name(), VertexType::float32,
                             static_cast<std::uint32_t>(offset), sizeof(Vertex)};
    };
    setAttribute(gl_, 0, 3, attribute(offsetof(Vertex, position)));
    setAttribute(gl_, 1, 3, attribute(offsetof(Vertex, normal)));
    setAttribute(gl_, 2, 2, attribute(offsetof(Vertex, uv)));
    mesh.label = desc.label;
    setLabel(gl_, GL_VERTEX_ARRAY, mesh.vertex_array.name(), desc.label);
    if (Status status = takeErrors(gl_, "createMesh", desc.label.c_str()); !status)
        return status.diagnostics();
    return MeshId{meshes_.add(std::move(mesh))};
}

Result<MeshId> GlDevice::adoptMesh(const HostMesh& host)
{
    if (Status status = checkMesh(host); !status) return status.diagnostics();
    if (Status status = checkCurrent(); !status) return status.diagnostics();
    Scope scope(*this);
    MeshSlot mesh;
    mesh.vertex_array = GlVertexArray::make(gl_);
    mesh.index_count = host.index_count;
    mesh.indexed = host.index_buffer != 0;
    mesh.index_type = host.index_type;
    mesh.index_offset = host.index_offset;
    mesh.label = host.label;
    mesh.normals = host.normal.buffer != 0;
    mesh.uv = host.uv.buffer != 0;
    gl_.BindVertexArray(mesh.vertex_array.name());
    if (Status status = checkBuffers(gl_, host); !status) return status.diagnostics();
    if (host.normal.buffer == 0 || host.uv.buffer == 0) {
        mesh.vertices = GlBuffer::make(gl_);
        gl_.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices.name());
        gl_.BufferData(GL_ARRAY_BUFFER, sizeof kConstants, kConstants, GL_STATIC_DRAW);
        if (host.normal.buffer == 0) setConstant(gl_, 1, 3, 0);
        if (host.uv.buffer == 0) setConstant(gl_, 2, 2, kConstantUv);
    }
    setAttribute(gl_, 0, 3, host.position);
    if (host.normal.buffer != 0) setAttribute(gl_, 1, 3, host.normal);
    if (host.uv.buffer != 0) setAttribute(gl_, 2, 2, host.uv);
    setLabel(gl_, GL_VERTEX_ARRAY, mesh.vertex_array.name(), host.label);
    if (Status status = takeErrors(gl_, "adoptMesh", host.label.c_str()); !status)
        return status.diagnostics();
    return MeshId{meshes_.add(std::move(mesh))};
}

void GlDevice::draw(MeshId id, std::uint32_t first, std::uint32_t count)
{
    const MeshSlot& mesh = meshes_.at(id.value);
    gl_.BindVertexArray(mesh.vertex_array.name());
    if (!mesh.indexed) {
        gl_.DrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(count));
        return;
    }
    constexpr GLenum kTypes[] = {GL_UNSIGNED_INT, GL_UNSIGNED_SHORT, GL_UNSIGNED_BYTE};
    const std::size_t begin = mesh.index_offset + std::size_t{first} * bytesOf(mesh.index_type);
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count),
                     kTypes[static_cast<int>(mesh.index_type)], asPointer(begin));
}

}  // namespace crevice
