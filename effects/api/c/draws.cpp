// SPDX-License-Identifier: MIT
// What an effect draws: meshes, and what the host draws by itself.
#include <crevice/frame.h>

#include "effects/api/c/handles.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

using namespace crevice;

namespace {

/// Calls what C knows of a draw.
void callHost(const DrawCall& call, void* host)
{
    const HostDraw& draw = *static_cast<const HostDraw*>(host);
    const crevice_draw_call made = {sizeof made, call.pass, call.program, &call};
    try {
        draw.callback(&made, draw.user);
    } catch (...) {
        *draw.threw = true;
    }
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
