// SPDX-License-Identifier: MIT
// Materials with their maps, and lights.
#include <crevice/frame.h>

#include "effects/api/c/handles.h"

#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

/// In the order of kMaterialMaps.
constexpr const crevice_texture* crevice_material::*kGivenMaps[] = {
    &crevice_material::base_color_map, &crevice_material::normal_map,
    &crevice_material::occlusion_map,  &crevice_material::metallic_roughness_map,
    &crevice_material::emission_map,
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
    const auto set = [](float number, float& into) { into = number != 0 ? number : into; };
    Material material;
    const glm::vec4 base_color = glm::make_vec4(given.base_color);
    if (base_color != glm::vec4(0.0f)) material.base_color = base_color;
    material.specular = glm::make_vec3(given.specular);
    set(given.shininess, material.shininess);
    material.ambient = 1.0f - given.ambient_dimming;
    material.alpha_cutoff = given.alpha_cutoff;
    set(given.normal_scale, material.normal_scale);
    set(given.occlusion_strength, material.occlusion_strength);
    material.blended = given.blended;
    material.metallic = given.metallic;
    material.roughness = 1.0f - given.smoothness;
    set(given.reflectance, material.reflectance);
    material.emission = glm::make_vec3(given.emission);
    material.unlit = given.unlit;
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
    ++frame.draws_revision;
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

/// What is 0 and may not be stays at its default.
Light lightOf(const crevice_light& given)
{
    const auto set = [](const float* vector, glm::vec3& into) {
        const glm::vec3 given_vector = glm::make_vec3(vector);
        if (given_vector != glm::vec3(0.0f)) into = given_vector;
    };
    Light light;
    light.directional = given.kind == CREVICE_DIRECTIONAL;
    light.spot = given.kind == CREVICE_SPOT;
    light.position = glm::make_vec3(given.position);
    set(given.direction, light.direction);
    light.color = glm::make_vec3(given.color);
    set(given.attenuation, light.attenuation);
    light.inner_angle_rad = given.inner_angle_rad;
    if (given.outer_angle_rad != 0) light.outer_angle_rad = given.outer_angle_rad;
    return light;
}

Status setLights(crevice_effect& effect, const crevice_light* lights, int count)
{
    const auto known = [](std::size_t, const crevice_light& light) {
        return checkEnum(light.kind, CREVICE_SPOT, "crevice_light_kind");
    };
    if (Status fine = takeEach(lights, count, "crevice_light", known); !fine) return fine;
    std::vector<Light>& own = effect.effect->frame().lights;
    own.resize(static_cast<std::size_t>(count));
    return takeEach(lights, count, "crevice_light", [&](std::size_t i, const auto& light) {
        own[i] = lightOf(light);
        return Status();
    });
}

}  // namespace

crevice_error* crevice_effect_set_materials(crevice_effect* effect,
                                            const crevice_material* materials, int count)
{
    return onEffect(effect, [&] { return setMaterials(*effect, materials, count); });
}

crevice_error* crevice_effect_set_lights(crevice_effect* effect, const crevice_light* lights,
                                         int count)
{
    return onEffect(effect, [&] { return setLights(*effect, lights, count); });
}

crevice_error* crevice_effect_set_ambient_light(crevice_effect* effect, const float* color)
{
    return onEffect(effect, [&] {
        Status given = checkGiven(color, "the colour");
        if (given) effect->effect->frame().ambient_light = glm::make_vec3(color);
        return given;
    });
}
