// SPDX-License-Identifier: MIT
#include "tools/render/scene/scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace crevice {

namespace {

// A derived near plane is at least this part of the far one: 24 bits of depth then still resolve
// a 16,000th of the far distance there.
constexpr double kLeastNearOverFar = 1e-3;

// What derived planes leave between themselves and the bounds, as a part of the diagonal.
constexpr double kDepthMargin = 0.01;

// Sets the planes to how far in front of the camera the bounds begin and end.
void encloseBounds(SceneCamera& range, const Bounds& bounds)
{
    range.near_distance = 1e300;
    range.far_distance = -1e300;
    for (int corner = 0; corner < 8; ++corner) {
        const double depth = -(range.view_from_world * glm::dvec4(bounds.corner(corner), 1.0)).z;
        range.near_distance = std::min(range.near_distance, depth);
        range.far_distance = std::max(range.far_distance, depth);
    }
    const double margin = kDepthMargin * (range.far_distance - range.near_distance) +
                          1e-6 * std::abs(range.far_distance);
    range.near_distance -= margin;
    range.far_distance += margin;
}

}  // namespace

SceneCamera withPlanes(const SceneCamera& camera, const Bounds& bounds)
{
    const bool complete = camera.orthographic || camera.near_distance > 0.0;
    if (camera.far_distance > camera.near_distance && complete) return camera;
    SceneCamera range = camera;
    range.near_distance = 0.1;
    range.far_distance = 100;
    if (!bounds.empty()) encloseBounds(range, bounds);
    if (range.far_distance <= 0.0) range.far_distance = 1.0;  // all of it lies behind the camera
    const double least = camera.orthographic ? 0.0 : range.far_distance * kLeastNearOverFar;
    range.near_distance = std::max(range.near_distance, least);
    if (camera.near_distance > 0.0) range.near_distance = camera.near_distance;
    if (range.far_distance <= range.near_distance) range.far_distance = range.near_distance * 2.0;
    return range;
}

void Bounds::add(const glm::dvec3& point)
{
    min = glm::min(min, point);
    max = glm::max(max, point);
}

double Bounds::diagonal() const { return empty() ? 0.0 : glm::length(max - min); }

glm::dvec3 Bounds::corner(int index) const
{
    return {index & 1 ? max.x : min.x, index & 2 ? max.y : min.y, index & 4 ? max.z : min.z};
}

MeshCorners::MeshCorners(const MeshDesc& mesh)
{
    std::vector<bool> used(mesh.vertices.size());
    for (const std::uint32_t index : mesh.indices) {
        if (used[index]) continue;
        used[index] = true;
        places.push_back(glm::make_vec3(mesh.vertices[index].position));
        box.add(places.back());
    }
}

Bounds Scene::bounds() const
{
    Bounds bounds;
    addCorners(bounds);
    return bounds;
}

long long triangleCount(const Scene& scene)
{
    long long count = 0;
    for (const SceneInstance& instance : scene.instances)
        count += static_cast<long long>(scene.meshes[instance.mesh].indices.size() / 3);
    return count;
}

glm::mat4 clipFromView(const SceneCamera& camera, Extent extent, const Bounds& bounds)
{
    const double aspect =
        static_cast<double>(std::max(extent.width, 1)) / std::max(extent.height, 1);
    const SceneCamera range = withPlanes(camera, bounds);
    const double half_height = camera.half_height, half_width = half_height * aspect;
    const glm::dmat4 centered =
        camera.orthographic ? glm::orthoRH_NO(-half_width, half_width, -half_height, half_height,
                                              range.near_distance, range.far_distance)
                            : glm::perspectiveRH_NO(camera.fov_y_rad, aspect, range.near_distance,
                                                    range.far_distance);
    const glm::dvec3 clip_shift = {-2.0 * camera.shift, 0.0};  // clip space is 2 wide
    return glm::translate(glm::dmat4(1.0), clip_shift) * centered;
}

}  // namespace crevice
