// SPDX-License-Identifier: MIT
#include "tools/render/scene/file/import.h"

#include <assimp/scene.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

glm::dvec3 vectorFrom(const aiVector3D& v) { return {v.x, v.y, v.z}; }

glm::dmat4 placeOf(const NodePlaces& places, const aiString& name)
{
    const auto place = places.find(name.C_Str());
    return place == places.end() ? glm::dmat4(1.0) : place->second;
}

// `fallback` where the direction has no length.
glm::dvec3 turned(const glm::dmat4& place, const aiVector3D& direction, const glm::dvec3& fallback)
{
    const glm::dvec3 world = glm::dmat3(place) * vectorFrom(direction);
    const double length = glm::length(world);
    return length > 0.0 && std::isfinite(length) ? world / length : fallback;
}

double verticalAngle(const aiCamera& camera)
{
    const double aspect = camera.mAspect > 0.0f ? camera.mAspect : 1.0;
    const double angle = 2.0 * std::atan(std::tan(camera.mHorizontalFOV * 0.5) / aspect);
    return angle > 0.0 && angle < 3.14 ? angle : SceneCamera().fov_y_rad;
}

SceneCamera cameraFrom(const aiCamera& from, const NodePlaces& places)
{
    SceneCamera camera;
    camera.name = from.mName.C_Str();
    const glm::dmat4 place = placeOf(places, from.mName);
    const glm::dvec3 eye = place * glm::dvec4(vectorFrom(from.mPosition), 1.0);
    const glm::dvec3 forward = turned(place, from.mLookAt, {0, 0, -1});
    camera.view_from_world = viewAlong(eye, forward, turned(place, from.mUp, {0, 1, 0}));
    camera.orthographic = from.mOrthographicWidth > 0.0f;
    if (camera.orthographic)
        camera.half_height = from.mOrthographicWidth / (from.mAspect > 0.0f ? from.mAspect : 1.0f);
    else
        camera.fov_y_rad = verticalAngle(from);
    camera.near_distance = std::max(from.mClipPlaneNear, 0.0f);
    camera.far_distance = from.mClipPlaneFar;
    return camera;
}

bool isSupported(const aiLight& light)
{
    return light.mType == aiLightSource_POINT || light.mType == aiLightSource_SPOT ||
           light.mType == aiLightSource_DIRECTIONAL;
}

SceneLight lightFrom(const aiLight& from, const NodePlaces& places)
{
    const glm::dmat4 place = placeOf(places, from.mName);
    SceneLight light;
    light.name = from.mName.C_Str();
    light.light.directional = from.mType == aiLightSource_DIRECTIONAL;
    light.light.position = place * glm::dvec4(vectorFrom(from.mPosition), 1.0);
    light.light.direction = turned(place, from.mDirection, {0, 0, -1});
    light.light.spot = from.mType == aiLightSource_SPOT;
    if (light.light.spot) {
        // A file that says nothing gives two pi.
        light.light.inner_angle_rad = std::min(from.mAngleInnerCone, glm::pi<float>());
        light.light.outer_angle_rad = std::min(from.mAngleOuterCone, glm::pi<float>());
    }
    light.light.color = {from.mColorDiffuse.r, from.mColorDiffuse.g, from.mColorDiffuse.b};
    light.light.attenuation = {from.mAttenuationConstant, from.mAttenuationLinear,
                               from.mAttenuationQuadratic};
    return light;
}

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

// Lights that are off stay so; where what one brings is no number, all go.
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

glm::dmat4 viewAlong(const glm::dvec3& eye, const glm::dvec3& forward, glm::dvec3 up)
{
    if (glm::length(glm::cross(forward, up)) < 1e-6) up = {forward.y, forward.z, forward.x};
    return glm::lookAt(eye, eye + forward, up);
}

void importCameras(const aiScene& from, const NodePlaces& places, Scene& scene)
{
    for (unsigned index = 0; index < from.mNumCameras; ++index)
        scene.cameras.push_back(cameraFrom(*from.mCameras[index], places));
}

void importLights(const aiScene& from, const NodePlaces& places, Scene& scene)
{
    for (unsigned index = 0; index < from.mNumLights; ++index)
        if (isSupported(*from.mLights[index]))
            scene.lights.push_back(lightFrom(*from.mLights[index], places));
}

}  // namespace crevice
