// SPDX-License-Identifier: MIT
// The draws of a frame: what of them changed, and the calls that draw passes make of them.
#include "core/run/execution.h"

#include "core/frame/frame_math.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace crevice {
namespace {

// What to cull of a draw in a pass that culls `cull`: the other side where it is mirrored, and
// nothing of a sheet.
Cull cullOf(Cull cull, const DrawItem& item, const Material& material, bool mirrored)
{
    if (cull == Cull::none || isSheet(item, material)) return Cull::none;
    if (!mirrored) return cull;
    return cull == Cull::back ? Cull::front : Cull::back;
}

}  // namespace

/// Whether draws, materials or their contents differ from the last frame.
bool Execution::updateDraws(const Frame& frame)
{
    const DrawItem no_draw;
    const Material no_material;
    bool changed = frame.revision != drawn_.revision;
    drawn_.revision = frame.revision;
    const auto take = [&changed](const auto& item, auto& taken) {
        if (taken == item) return;
        taken = item;
        changed = true;
    };
    changed = changed || frame.draws.size() != drawn_.draws.size();
    drawn_.draws.resize(frame.draws.size());
    drawn_.origins.resize(frame.draws.size());
    drawn_.elided = false;
    for (std::size_t i = 0; i < frame.draws.size(); ++i) {
        const DrawItem& item = frame.draws[i];
        const bool drawn = drawsSomething(item) && isDrawable(frame, item, device_);
        drawn_.elided = drawn_.elided || (drawsSomething(item) && !drawn);
        changed = changed || (drawn && item.callback && item.revision == 0);
        if (drawn) {
            const ObjectInfo mesh = device_.info(item.mesh);
            warnings_.look(item, mesh, frame.materials[item.material]);
            drawn_.origins[i] = mesh.origin;
        }
        take(drawn ? item : no_draw, drawn_.draws[i]);
    }
    changed = changed || frame.materials.size() != drawn_.materials.size();
    drawn_.materials.resize(frame.materials.size());
    for (std::size_t i = 0; i < frame.materials.size(); ++i)
        take(isFinite(frame.materials[i]) ? frame.materials[i] : no_material, drawn_.materials[i]);
    drawn_.elided = drawn_.elided || !isFinite(frame.ambient_light) ||
                    !std::all_of(frame.lights.begin(), frame.lights.end(),
                                 [](const Light& light) { return isFinite(light); });
    return changed;
}

/// Where a bounded pass is drawn.
PixelArea Execution::areaOf(const PreparedPass& pass)
{
    const Extent& extent = pass.info.extent;
    const int length = pass.plan->cull_below_pixel;
    constexpr double kAny = std::numeric_limits<double>::infinity();
    return pixelsOf(view_draws_.area(extent, length >= 0 ? values_.param(length) : kAny), extent);
}

void Execution::runDraws(const PreparedPass& pass, const CameraMatrices& camera)
{
    StateDesc state = pass.state;
    SentDraw sent;
    const bool culls = pass.plan->frustum_scale > 0.0f;
    const ViewVolume volume = culls ? viewVolume(camera, pass.plan->frustum_scale) : ViewVolume();
    const std::vector<PlacedDraw>& placed = view_draws_.placed();
    for (std::size_t i = 0; i < drawn_.draws.size(); ++i) {
        const DrawItem& item = drawn_.draws[i];
        if (!drawsSomething(item) || (culls && isOutside(placed[i].sphere, volume))) continue;
        const Cull cull =
            cullOf(pass.state.cull, item, drawn_.materials[item.material], placed[i].mirrored);
        if (cull != state.cull) {
            state.cull = cull;
            device_.setProgram(pass.program, state);
            setTextures(pass.textures);
            sent.material = nullptr;
        }
        setDraw(pass, i, sent);
        if (item.callback) {
            values_.takeDraw(sent.values);
            drawByHost(pass, item);
            device_.setProgram(pass.program, state);
            setTextures(pass.textures);
            setUniforms(pass.uniforms);
            sent = {};
        } else {
            device_.draw(item.mesh, item.first, item.count);
        }
    }
}

/// Sends the uniforms and binds the textures of a draw, but for what they are already.
void Execution::setDraw(const PreparedPass& pass, std::size_t draw, SentDraw& sent)
{
    const Material& material = drawn_.materials[drawn_.draws[draw].material];
    const std::uint32_t* const values = view_draws_.values(draw, values_);
    for (const UniformBinding& uniform : pass.draw_uniforms) {
        const std::size_t at = uniform.offset - values_.drawOffset();
        const std::size_t bytes = wordsOf(uniform.type, uniform.count) * sizeof *values;
        if (!sent.values || std::memcmp(values + at, sent.values + at, bytes) != 0)
            device_.setUniform(uniform.location, uniform.type, uniform.count, values + at);
    }
    for (const TextureBinding& binding : pass.material_textures) {
        const auto map = kMaterialMaps[binding.map].texture;
        const TextureId texture = material.*map;
        if (sent.material && (sent.material->*map).value == texture.value) continue;
        device_.setTexture(binding.location, binding.unit, texture ? texture : white_.id(),
                           binding.sampling);
    }
    sent = {values, &material};
}

void Execution::drawByHost(const PreparedPass& pass, const DrawItem& item)
{
    struct Call {
        const char* pass;
        const DrawItem& item;
        const ValueTable& values;
    } call{pass.info.label, item, values_};
    const auto draw = [](std::uint32_t program, void* data) {
        const Call& made = *static_cast<Call*>(data);
        made.item.callback({made.pass, program, made.values}, made.item.host);
    };
    device_.drawByHost(draw, &call);
}

}  // namespace crevice
