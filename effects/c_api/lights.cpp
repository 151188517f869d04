// SPDX-License-Identifier: MIT
// Lights, and the light of the surroundings.
#include <crevice/frame.h>

#include "effects/c_api/effect.h"
#include "effects/c_api/structs.h"

#include <glm/gtc/type_ptr.hpp>

using namespace crevice;

namespace {

/// Errors: CV6011 for an unknown kind.
Status checkLight(std::size_t index, const crevice_light& light)
{
    const int kind = numberOf(light.kind);
    if (kind >= CREVICE_POINT && kind <= CREVICE_SPOT) return {};
    return Diagnostic{Code::bad_input,
                      "light " + std::to_string(index) + " has kind " + std::to_string(kind) +
                          ", and there is none such",
                      "take one of crevice_light_kind, such as CREVICE_SPOT"};
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
    if (Status fine = takeEach(lights, count, "crevice_light", checkLight); !fine) return fine;
    std::vector<Light>& own = effect.effect->frame().lights;
    own.resize(static_cast<std::size_t>(count));
    return takeEach(lights, count, "crevice_light", [&](std::size_t i, const auto& light) {
        own[i] = lightOf(light);
        return Status();
    });
}

}  // namespace

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
