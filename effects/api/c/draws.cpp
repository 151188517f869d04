// SPDX-License-Identifier: MIT
// What an effect draws: meshes, copied or in buffers of the host's, and what the host draws itself.
#include <crevice/frame.h>

#include "effects/api/c/handles.h"

#include <glm/gtc/type_ptr.hpp>

#include <numeric>

using namespace crevice;

namespace {

/// Calls what C knows of a draw.
void callHost(const DrawCall& call, void* host)
{
    const HostDraw& draw = *static_cast<const HostDraw*>(host);
    const crevice_draw_call made = {sizeof made, call.pass, call.program, &call};
    if (!calledWhole([&] { draw.callback(&made, draw.user); })) *draw.threw = true;
}

std::uint32_t indicesOf(const SharedMesh& mesh)
{
    return mesh.device->info(mesh.id.id()).index_count;
}

/// Errors: CV6011.
Status checkDraw(const crevice_effect& effect, std::size_t index, const crevice_draw& draw)
{
    const auto bad = [index](const std::string& what, const char* help) -> Status {
        return Diagnostic{Code::bad_input, "draw " + std::to_string(index) + " " + what, help};
    };
    if (draw.callback) return {};
    if (!draw.mesh) return bad("has neither mesh nor callback", "leave it out of the array");
    const SharedMesh& mesh = *draw.mesh->shared;
    if (mesh.device != effect.device)
        return bad("has a mesh of another device", "make the mesh on the effect's device");
    const std::uint32_t has = indicesOf(mesh);
    if (std::uint64_t{draw.first} + draw.count <= has) return {};
    return bad("begins at index " + std::to_string(draw.first) + " and has " +
                   std::to_string(draw.count) + ", and its mesh has " + std::to_string(has),
               "first and count are indices, not triangles");
}

DrawItem itemOf(const crevice_draw& draw, HostDraw& host)
{
    DrawItem item;
    if (draw.callback) {
        item.callback = callHost;
        item.host = &host;
    } else {
        item.mesh = host.mesh->id.id();
        item.first = draw.first;
        item.count = draw.count > 0 ? draw.count : indicesOf(*host.mesh) - draw.first;
    }
    item.world_from_model = matrixOf(draw.world_from_model);
    item.material = draw.material;
    item.bounds_center = glm::make_vec3(draw.bounds_center);
    item.bounds_radius = draw.bounds_radius == 0 ? -1.0f : draw.bounds_radius;
    item.sheet = draw.sheet;
    item.revision = draw.revision;
    return item;
}

/// Whether `host` becomes another draw than it was. A DrawItem does not tell: it names the mesh by
/// an id that may be given out again, and not the host's callback.
bool replace(HostDraw& host, const crevice_draw& draw, bool& threw)
{
    const std::shared_ptr<const SharedMesh> none;
    const auto& mesh = draw.callback ? none : draw.mesh->shared;
    if (host.mesh == mesh && host.callback == draw.callback && host.user == draw.user) return false;
    host = {mesh, draw.callback, draw.user, &threw};
    return true;
}

Status setDraws(crevice_effect& effect, const crevice_draw* draws, int count)
{
    const Status fine = takeEach(draws, count, "crevice_draw", [&](auto i, const auto& draw) {
        return checkDraw(effect, i, draw);
    });
    if (!fine) return fine;
    Frame& frame = effect.effect->frame();
    HostScene& scene = effect.scene;
    const auto size = static_cast<std::size_t>(count);
    frame.draws.reserve(size);  // what may throw comes before what changes
    scene.draws.reserve(size);
    bool changed = size != scene.draws.size();
    ++frame.draws_revision;
    frame.draws.resize(size);
    scene.draws.resize(size);
    const auto put = [&](std::size_t i, const crevice_draw& draw) {
        changed = replace(scene.draws[i], draw, scene.callback_threw) || changed;
        frame.draws[i] = itemOf(draw, scene.draws[i]);
        return Status();
    };
    const Status taken = takeEach(draws, count, "crevice_draw", put);
    if (changed) ++frame.revision;
    return taken;
}

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

glm::dmat4 crevice::matrixOf(const double (&numbers)[16])
{
    const bool none = std::all_of(numbers, numbers + 16, [](double each) { return each == 0; });
    return none ? glm::dmat4(1.0) : glm::make_mat4(numbers);
}

const float* crevice_draw_call_matrix(const crevice_draw_call* call, const char* name)
{
    if (!call || !name) return nullptr;
    return static_cast<const DrawCall*>(call->values)->matrix(name);
}

crevice_error* crevice_effect_set_draws(crevice_effect* effect, const crevice_draw* draws,
                                        int count)
{
    return onEffect(effect, [&] { return setDraws(*effect, draws, count); });
}

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
