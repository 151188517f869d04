// SPDX-License-Identifier: MIT
// What tests of the ray tracer share: scenes at places in the world, and pictures of them.
#pragma once

#include "tools/measure/reference/tracer.h"

#include "core/base/text.h"

#include "tests/support/need.h"
#include "tools/render/scene/mesh_shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstring>

namespace crevice {

constexpr double kMaxBias = 0.001;
constexpr double kSize = 100.0;  ///< Of most scenes here, before Placement::scale.

inline const MeshDesc kFloor = makeQuad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
inline const MeshDesc kWall = makeQuad({-50, 0, 0}, {100, 0, 0}, {0, 50, 0});

/// Where a scene of about kSize lies in the world.
struct Placement {
    double scale = 1.0;
    glm::dvec3 offset = glm::dvec3(0.0);
    bool tilted = false;

    glm::dmat4 matrix() const
    {
        const glm::dmat4 moved = glm::translate(glm::dmat4(1), offset);
        const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 0.3, 0.2));
        const glm::dmat4 turned = tilted ? glm::rotate(moved, 0.7, axis) : moved;
        return glm::scale(turned, glm::dvec3(scale));
    }
};

inline const Placement kPlacements[] = {{},
                                        {1, {0, 0, 0}, true},
                                        {1e-6, {0, 0, 0}, true},
                                        {1e6, {0, 0, 0}, true},
                                        {1, {1e3, -1e3, 1e3}, true},
                                        {1, {1e7, 0, 1e7}, false},
                                        {1, {1e7, -1e7, 1e7}, true},
                                        {1e6, {1e7, 1e7, 1e7}, true}};

inline const double kRadii[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1,
                                1,    10,   1e3,  1e6,  1e9};  // in kSize

/// A scene, and a camera that looks along -y of the model at a square of `half` to each side.
struct Shot {
    Scene scene;
    Camera camera;
};

inline Scene sceneOf(const std::vector<MeshDesc>& meshes)
{
    Scene scene;
    scene.meshes = meshes;
    scene.materials.emplace_back();
    for (int index = 0; index < static_cast<int>(meshes.size()); ++index)
        scene.instances.push_back({index});
    return scene;
}

// Model coordinates all: `height` is that of the eye over `center`; below 0 it looks up.
inline Shot shotOf(Scene scene, const Placement& placement, const glm::dvec3& center, double half,
                   double height)
{
    for (SceneInstance& instance : scene.instances)
        instance.world_from_model = placement.matrix() * instance.world_from_model;
    const glm::dvec3 eye = center + glm::dvec3(0, height, 0);
    const glm::dmat4 view = glm::lookAt(eye, center, glm::dvec3(0, 0, -1));
    const auto side = static_cast<float>(half), end = static_cast<float>(2 * std::abs(height));
    return {
        std::move(scene),
        {view * glm::inverse(placement.matrix()), glm::ortho(-side, side, -side, side, 0.0f, end)}};
}

/// Of a Scene or a RayScene.
template <class AnyScene>
Image trace(const AnyScene& scene, const Camera& camera, Extent extent, double radius, int rays)
{
    return need(traceAmbientOcclusion(scene, camera, extent, {radius, rays}));
}

inline Image trace(const Shot& shot, Extent extent, double radius, int rays = 4096)
{
    return trace(shot.scene, shot.camera, extent, radius, rays);
}

inline bool sameBits(const Image& a, const Image& b)
{
    return a.extent == b.extent && a.pixels.size() == b.pixels.size() &&
           std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)) == 0;
}

/// Root of the mean square of the difference, over the pixels that see a surface in both.
inline double rmsDifference(const Image& a, const Image& b)
{
    double sum = 0;
    int seen = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        if (std::isnan(a.pixels[k]) || std::isnan(b.pixels[k])) continue;
        sum += std::pow(a.pixels[k] - b.pixels[k], 2.0);
        ++seen;
    }
    REQUIRE(seen > 0);
    return std::sqrt(sum / seen);
}

inline double meanOf(const Image& image)
{
    double sum = 0;
    for (const float value : image.pixels) sum += value;
    return sum / static_cast<double>(image.pixels.size());
}

inline std::string describe(const Placement& placement, double radius)
{
    return "scale " + significant(placement.scale, 3) + ", offset " +
           significant(placement.offset.x, 3) + (placement.tilted ? ", tilted" : "") + ", radius " +
           significant(radius, 3);
}

}  // namespace crevice
