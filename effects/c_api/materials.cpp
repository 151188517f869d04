// SPDX-License-Identifier: MIT
// Materials and their maps.
#include <crevice/frame.h>

#include "effects/c_api/effect.h"
#include "effects/c_api/structs.h"
#include "effects/c_api/textures.h"

#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

/// In the order of kMaterialMaps.
constexpr const crevice_texture* crevice_material::*kGivenMaps[] = {
    &crevice_material::base_color_map,
    &crevice_material::normal_map,
    &crevice_material::occlusion_map,
};
static_assert(std::size(kGivenMaps) == std::size(kMaterialMaps));

/// A map that takes the place of another.
struct NewMap {
    std::size_t material, map;
    HostMap made;
};

/// Errors: CV6011; those of Device::adoptTexture.
Result<HostMap> adopt(Device& device, HostTexture host, std::size_t material, const char* map)
{
    host.label = "material " + std::to_string(material) + "'s " + map;
    if (host.samples > 1 && !host.copied())
        return Diagnostic{Code::bad_input, host.label + " has several samples a pixel",
                          "resolve it, or set part, and crevice takes a resolved copy"};
    const Result<TextureId> id = device.adoptTexture(host);
    if (!id) return id.diagnostics();
    return HostMap{std::move(host), Owned<TextureId>(device, *id)};
}

/// Adds those maps of a material that are others than before.
Status findNewMaps(const crevice_effect& effect, std::size_t index, const crevice_material& given,
                   std::vector<NewMap>& maps)
{
    static const HostMaterial none;
    const auto& before = effect.scene.materials;
    const HostMaterial& old = index < before.size() ? before[index] : none;
    for (std::size_t i = 0; i < std::size(kMaterialMaps); ++i) {
        const crevice_texture* texture = given.*kGivenMaps[i];
        if (!texture) continue;
        HostTexture host;
        if (Status taken = takeTexture(texture, host); !taken) return taken;
        if (old.maps[i].id.id() && old.maps[i].host == host) continue;
        Result<HostMap> made = adopt(*effect.device, std::move(host), index, kMaterialMaps[i].name);
        if (!made) return made.diagnostics();
        maps.push_back({index, i, std::move(*made)});
    }
    return {};
}

/// Without maps. What is 0 stays at its default.
Material materialOf(const crevice_material& given)
{
    const auto set = [](float number, float& into) {
        if (number != 0) into = number;
    };
    Material material;
    const glm::vec4 base_color = glm::make_vec4(given.base_color);
    if (base_color != glm::vec4(0.0f)) material.base_color = base_color;
    material.specular = glm::make_vec3(given.specular);
    set(given.shininess, material.shininess);
    material.ambient = 1.0f - given.ambient_dimming;
    material.alpha_cutoff = given.alpha_cutoff;
    set(given.normal_scale, material.normal_scale);
    set(given.occlusion_strength, material.occlusion_strength);
    return material;
}

/// Whether a map was dropped, or holds something else.
bool put(const crevice_material& given, HostMaterial& host, Material& material)
{
    const bool changed = host.revision != given.revision;
    host.revision = given.revision;
    material = materialOf(given);
    for (std::size_t i = 0; i < std::size(kMaterialMaps); ++i) {
        if (!(given.*kGivenMaps[i])) host.maps[i] = {};
        material.*kMaterialMaps[i].texture = host.maps[i].id.id();
    }
    return changed;
}

Status setMaterials(crevice_effect& effect, const crevice_material* materials, int count)
{
    std::vector<NewMap> maps;
    const auto find = [&](std::size_t i, const crevice_material& given) {
        return findNewMaps(effect, i, given, maps);
    };
    if (Status fine = takeEach(materials, count, "crevice_material", find); !fine) return fine;
    Frame& frame = effect.effect->frame();
    std::vector<HostMaterial>& hosts = effect.scene.materials;
    const auto size = static_cast<std::size_t>(count);
    frame.materials.reserve(std::max<std::size_t>(size, 1));  // what may throw comes first
    hosts.reserve(size);
    frame.materials.assign(std::max<std::size_t>(size, 1), Material());
    hosts.resize(size);
    for (NewMap& each : maps) hosts[each.material].maps[each.map] = std::move(each.made);
    // Ids are given out again: that of a new map may be the one that was drawn with last.
    bool changed = !maps.empty();
    const auto put_each = [&](std::size_t i, const crevice_material& given) {
        changed = put(given, hosts[i], frame.materials[i]) || changed;
        return Status();
    };
    const Status taken = takeEach(materials, count, "crevice_material", put_each);
    if (changed) ++frame.revision;
    return taken;
}

}  // namespace

crevice_error* crevice_effect_set_materials(crevice_effect* effect,
                                            const crevice_material* materials, int count)
{
    return onEffect(effect, [&] { return setMaterials(*effect, materials, count); });
}
