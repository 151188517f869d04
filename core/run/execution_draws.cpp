// SPDX-License-Identifier: MIT
// The draws of a frame: whether they are those of the last one, and drawing them.
#include "core/run/execution.h"

namespace crevice {
namespace {

Cull otherSide(Cull cull)
{
    return cull == Cull::none ? cull : cull == Cull::back ? Cull::front : Cull::back;
}

// Of the triangles that a draw takes from a mesh those of sheets, as they stand once more.
IndexRange sheetsIn(const DrawItem& item, const ObjectInfo& mesh)
{
    if (item.callback || !mesh.sheets || item.first % 3 != 0) return {};
    const auto begin = std::lower_bound(mesh.sheets->begin(), mesh.sheets->end(), item.first);
    const auto end = std::lower_bound(begin, mesh.sheets->end(), item.first + item.count);
    const auto before = static_cast<std::uint32_t>(begin - mesh.sheets->begin());
    return {mesh.index_count + 3 * before, static_cast<std::uint32_t>(3 * (end - begin))};
}

bool lightsAreFinite(const Frame& frame)
{
    return isFinite(frame.ambient_light) &&
           allOf(frame.lights, [](const Light& light) { return isFinite(light); });
}

// Whether it was another.
template <class T>
bool take(const T& given, T& taken)
{
    if (taken == given) return false;
    taken = given;
    return true;
}

}  // namespace

bool Execution::sameDraws(const Frame& frame)
{
    // Bytes first: padding may differ of what is equal, and 0 may have a sign.
    const auto same = [](const auto& list, const auto& taken) {
        return std::equal(list.begin(), list.end(), taken.begin(), taken.end(),
                          [](const auto& a, const auto& b) {
                              return std::memcmp(&a, &b, sizeof a) == 0 || a == b;
                          });
    };
    const std::uint64_t given = frame.draws_revision;
    const bool told = given != 0 && given == drawn_.draws_revision;
    same_draws_ =
        drawn_.steady && frame.revision == drawn_.revision && lightsAreFinite(frame) &&
        frame.draws.size() == drawn_.draws.size() &&
        frame.materials.size() == drawn_.materials.size() &&
        (told || (same(frame.draws, drawn_.draws) && same(frame.materials, drawn_.materials)));
    if (same_draws_) drawn_.draws_revision = given;
    return same_draws_;
}

/// Looks at draws, materials and lights. Whether those or their contents differ from the last
/// frame.
bool Execution::takeDraws(const Frame& frame)
{
    bool changed = frame.revision != drawn_.revision || frame.draws.size() != drawn_.draws.size() ||
                   frame.materials.size() != drawn_.materials.size();
    drawn_.revision = frame.revision;
    drawn_.draws_revision = frame.draws_revision;
    drawn_.draws.resize(frame.draws.size());
    drawn_.origins.resize(frame.draws.size());
    drawn_.sheets.resize(frame.draws.size());
    drawn_.elided = !lightsAreFinite(frame);
    drawn_.steady = true;
    for (std::size_t i = 0; i < frame.draws.size(); ++i) changed = takeDraw(frame, i) || changed;
    drawn_.materials.resize(frame.materials.size());
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        const Material& given = frame.materials[i];
        changed = take(isFinite(given) ? given : Material(), drawn_.materials[i]) || changed;
    }
    drawn_.steady = drawn_.steady && !drawn_.elided;
    return changed;
}

/// Of a draw the same.
bool Execution::takeDraw(const Frame& frame, std::size_t index)
{
    const DrawItem& item = frame.draws[index];
    DrawItem& taken = drawn_.draws[index];
    if (!drawsSomething(item)) {
        const bool changed = drawsSomething(taken);
        taken = item;
        return changed;
    }
    if (!isDrawable(frame, item, device_)) {
        drawn_.elided = true;
        return take(DrawItem(), taken);
    }
    const ObjectInfo mesh = device_.info(item.mesh);
    warnings_.look(item, mesh, frame.materials[item.material]);
    drawn_.origins[index] = mesh.origin;
    drawn_.sheets[index] = sheetsIn(item, mesh);
    const bool unsteady = item.callback && item.revision == 0;
    drawn_.steady = drawn_.steady && !unsteady;
    return take(item, taken) || unsteady;
}

void Execution::runDraws(const PreparedPass& pass, const CameraMatrices& camera, ViewDraws& draws)
{
    StateDesc state = pass.state;
    SentDraw sent;
    const bool culls = pass.plan->frustum_scale > 0.0f;
    const ViewVolume volume = culls ? viewVolume(camera, pass.plan->frustum_scale) : ViewVolume();
    const std::vector<PlacedDraw>& placed = draws.placed();
    for (const std::size_t i : draws.drawnBy(*pass.plan)) {
        const DrawItem& item = drawn_.draws[i];
        if (culls && isOutside(placed[i].sphere, volume)) continue;
        const IndexRange sheets = drawn_.sheets[i];
        const bool sheet =
            isSheet(item, drawn_.materials[item.material]) || sheets.count == item.count;
        const Cull cull = sheet                ? Cull::none
                          : placed[i].mirrored ? otherSide(pass.state.cull)
                                               : pass.state.cull;
        const auto set = [&](Cull side) {
            if (side != state.cull) {
                state.cull = side;
                device_.setProgram(pass.program, state);
                setTextures(pass.textures);
                sent.material = nullptr;
            }
            setDraw(pass, i, draws, sent);
        };
        set(cull);
        if (item.callback) {
            values_.takeDraw(sent.values);
            drawByHost(pass, item);
            device_.setProgram(pass.program, state);
            setTextures(pass.textures);
            setUniforms(pass.uniforms);
            sent = {};
        } else {
            device_.draw(item.mesh, item.first, item.count);
            if (cull == Cull::none || sheets.count == 0) continue;
            set(otherSide(cull));
            device_.draw(item.mesh, sheets.first, sheets.count);
        }
    }
}

/// Sends the uniforms and binds the textures of a draw, but for what they are already.
void Execution::setDraw(const PreparedPass& pass, std::size_t draw, ViewDraws& draws,
                        SentDraw& sent)
{
    const Material& material = drawn_.materials[drawn_.draws[draw].material];
    const std::uint32_t* const values = draws.values(draw, values_);
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
