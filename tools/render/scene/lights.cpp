// SPDX-License-Identifier: MIT
// Lights of any unit, and of none.
#include "tools/render/scene/lights.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

// A light nearer to the scene's centre than this part of its size counts as that far away.
constexpr double kLeastLightDistance = 0.05;

// 1 / attenuation at the centre of the scene.
double dimming(const Light& light, const Bounds& bounds)
{
    if (light.directional) return 1.0;
    const double distance = std::max(glm::length(light.position - bounds.center()),
                                     kLeastLightDistance * bounds.diagonal());
    const glm::dvec3 a = light.attenuation;
    const double divisor = a.x + a.y * distance + a.z * distance * distance;
    return divisor > 0.0 && std::isfinite(divisor) ? divisor : 1.0;
}

}  // namespace

void normalizeLights(Scene& scene)
{
    std::vector<SceneLight>& lights = scene.lights;
    const Bounds bounds = scene.bounds();
    double brightest = 0.0;
    for (SceneLight& each : lights) {
        Light& light = each.light;
        const double divisor = dimming(light, bounds);
        light.attenuation = light.directional ? glm::vec3(1, 0, 0)
                                              : glm::vec3(glm::dvec3(light.attenuation) / divisor);
        if (light.attenuation == glm::vec3(0.0f)) light.attenuation.x = 1.0f;
        light.color = glm::max(glm::vec3(glm::dvec3(light.color) / divisor), glm::vec3(0.0f));
        brightest = std::max<double>({brightest, light.color.r, light.color.g, light.color.b});
    }
    if (!std::isfinite(brightest)) return lights.clear();
    for (SceneLight& each : lights)
        if (brightest > 0.0) each.light.color /= static_cast<float>(brightest);
}

void addDefaultLight(Scene& scene)
{
    if (!scene.lights.empty()) return;
    SceneLight light;
    light.name = "default";
    light.light.directional = true;
    light.light.direction = glm::normalize(glm::vec3(-0.4f, -0.8f, -0.6f));
    light.light.color = glm::vec3(0.7f);
    scene.lights.push_back(light);
}

}  // namespace crevice
